(** LG: the paper's literal parameters fail (theory.md section 2).

    Paper, section 2.2: "Let phi be the minimum of pi/4 and the angle between two edges
    that share a vertex"; section 3.2: "The values of d_e and r defined above can be
    used ... We do not take into account dihedral angles at this point."; section 2.3:
    d_e "can be computed in the same manner h is computed", that is d_e = r sin beta
    with beta a fixed fraction of phi.

    [W3_literal_rule_fails]: on a complex of 5 vertices and 3 triangles, for every
    beta >= phi/4 (phi/3 and phi/4 among them), every radius r and every subdivision of
    the arc, no sphere through the vertices of the spoke triangle under edge 03 is empty:
    each of them contains the cap point of edge 03 or that of edge 04 strictly. So
    Lemma 1.2 cannot hold for that triangle, whatever is done elsewhere. *)
From Coq Require Import Reals Lra Psatz List.
From Confidel.lemmas Require Import Space EdgeFaceAngle.
Import ListNotations.
Open Scope R_scope.

(** ** phi of an explicit complex, by exact arithmetic *)

(** cos of the angle at v between va and vb is at most C, where c2 = C^2, C >= 0. *)
Definition angle_cos2_le (c2 : R) (t : vec * vec * vec) :=
  let '(v, a, b) := t in
  let x := vsub a v in let y := vsub b v in
  dot x y <= 0 \/ dot x y * dot x y <= c2 * (norm2 x * norm2 y).
Definition angle_cos2_eq (c2 : R) (t : vec * vec * vec) :=
  let '(v, a, b) := t in
  let x := vsub a v in let y := vsub b v in
  0 < dot x y /\ dot x y * dot x y = c2 * (norm2 x * norm2 y).

(** W3: vertices 0..4, triangles 012, 013, 014. *)
Definition w0 := Vec 0 0 0.
Definition w1 := Vec 20 0 0.
Definition w2 := Vec 0 20 0.
Definition w3 := Vec 20 20 1.
Definition w4 := Vec 10 10 (-14).
(** All pairs of edges (01 02 03 04 12 13 14) that share a vertex: (vertex, end, end). *)
Definition w3_edge_pairs : list (vec * vec * vec) :=
  [ (w0,w1,w2); (w0,w1,w3); (w0,w1,w4); (w0,w2,w3); (w0,w2,w4); (w0,w3,w4);
    (w1,w0,w2); (w1,w0,w3); (w1,w0,w4); (w1,w2,w3); (w1,w2,w4); (w1,w3,w4);
    (w2,w0,w1); (w3,w0,w1); (w4,w0,w1) ].

(** phi of W3: cos^2 phi = 50/99 (phi = 44.7106 degrees, below pi/4 since 50/99 > 1/2),
    attained at vertex 1 between the edges 12 and 14. *)
Theorem W3_phi : (forall t, In t w3_edge_pairs -> angle_cos2_le (50 / 99) t) /\
  In (w1, w2, w4) w3_edge_pairs /\ angle_cos2_eq (50 / 99) (w1, w2, w4).
Proof.
  split; [|split; [simpl; tauto|]].
  - intros t H. unfold w3_edge_pairs in H. simpl in H.
    repeat match goal with H : _ \/ _ |- _ => destruct H as [H|H] end; try contradiction; subst t;
      unfold angle_cos2_le, norm2, dot, vsub, w0, w1, w2, w3, w4; simpl; lra.
  - unfold angle_cos2_eq, norm2, dot, vsub, w0, w1, w2, w3, w4; simpl; lra.
Qed.

(** cos(phi/4) from cos^2 phi = 50/99, by halving twice. *)
Lemma cos_quarter phi : 0 <= phi <= PI / 2 -> cos phi * cos phi = 50 / 99 -> cos (phi / 4) <= 982 / 1000.
Proof.
  intros Hp C. pose proof PI_RGT_0.
  assert (C0 : 0 <= cos phi) by (apply cos_ge_0; lra).
  assert (C1 : 0 <= cos (phi / 2)) by (apply cos_ge_0; lra).
  assert (C2 : 0 <= cos (phi / 4)) by (apply cos_ge_0; lra).
  assert (E1 : cos phi = 2 * cos (phi / 2) * cos (phi / 2) - 1).
  { replace phi with (2 * (phi / 2)) at 1 by field. apply cos_2a_cos. }
  assert (E2 : cos (phi / 2) = 2 * cos (phi / 4) * cos (phi / 4) - 1).
  { replace (phi / 2) with (2 * (phi / 4)) at 1 by field. apply cos_2a_cos. }
  assert (U0 : cos phi <= 711 / 1000) by (apply sq_le; lra).
  assert (U1 : cos (phi / 2) <= 925 / 1000) by (apply sq_le; lra).
  apply sq_le; lra.
Qed.

(** ** The two obstructing cap points *)

(** A sphere through the origin, p and q centred at c: x is strictly inside iff
    |x|^2 < 2 c.x. *)
Definition inside_at_origin c x := strictly_inside c vzero x.
Lemma inside_at_origin_iff c x : inside_at_origin c x <-> norm2 x < 2 * dot c x.
Proof.
  unfold inside_at_origin, strictly_inside.
  replace (power c vzero x) with (norm2 x - 2 * dot c x) by vring. split; intros; lra.
Qed.

(** Sphere through the origin and both arc ends p, q of a spoke: the component of its
    centre along the bisector b is r / (2 cos a). *)
Lemma centre_along_bisector b g r a c : orthonormal2 b g -> 0 < r -> 0 < cos a ->
  dist2 c vzero = dist2 c (spoke_start b g r a) -> dist2 c vzero = dist2 c (spoke_end b g r a) ->
  dot c b = r / (2 * cos a) /\ (sin a <> 0 -> dot c g = 0).
Proof.
  intros O Hr Ha P Q.
  assert (F : forall x, dist2 c vzero = dist2 c x -> 2 * dot c x = norm2 x).
  { intros x E. assert (dist2 c x = dist2 c vzero + norm2 x - 2 * dot c x) by vring. lra. }
  apply F in P. apply F in Q. unfold spoke_start, spoke_end in P, Q.
  rewrite norm2_in_face in P, Q by exact O. unfold in_face in P, Q.
  rewrite dot_add_r, !dot_scale_r in P, Q. rewrite cos_neg, sin_neg in P.
  assert (K : 2 * (r * cos a * dot c b) = r * r) by lra.
  assert (L : r * sin a * dot c g = 0) by lra.
  split.
  - apply Rmult_eq_reg_r with (2 * r * cos a); [|nra].
    replace (r / (2 * cos a) * (2 * r * cos a)) with (r * r) by (field; lra). lra.
  - intros S. apply Rmult_integral in L. destruct L as [L|L]; [|exact L].
    apply Rmult_integral in L. destruct L; [lra|contradiction].
Qed.

(** The face is the plane z = 0; the two edges project onto the diagonal (1,1,0). A spoke
    with half-angle a whose bisector is at angle lambda from the diagonal, |lambda| <= a. *)
Section DiagonalEdges.
Variables r a lambda beta : R.
Hypothesis Hr : 0 < r.
Hypothesis Ha : 0 < a < PI / 2.
Hypothesis Hl : - a <= lambda <= a.
Hypothesis Hb : 0 < beta < PI / 2.

Definition diag_b := Vec (cos (PI / 4 + lambda)) (sin (PI / 4 + lambda)) 0.
Definition diag_g := Vec (- sin (PI / 4 + lambda)) (cos (PI / 4 + lambda)) 0.

Lemma diag_orthonormal : orthonormal2 diag_b diag_g.
Proof.
  pose proof (sin2_cos2 (PI / 4 + lambda)) as E. unfold Rsqr in E.
  unfold orthonormal2, diag_b, diag_g, norm2, dot; simpl. repeat split; lra.
Qed.

Lemma cos_lambda_ge : cos a <= cos lambda.
Proof.
  pose proof PI_RGT_0. destruct (Rle_dec 0 lambda); [apply cos_decr_1; lra|].
  rewrite <- (cos_neg lambda). apply cos_decr_1; lra.
Qed.

(** Any such sphere's centre has x + y >= r / sqrt 2. *)
Lemma centre_diagonal c :
  dist2 c vzero = dist2 c (spoke_start diag_b diag_g r a) ->
  dist2 c vzero = dist2 c (spoke_end diag_b diag_g r a) ->
  r <= sqrt 2 * (vx c + vy c).
Proof.
  intros P Q. pose proof PI_RGT_0.
  assert (Ca : 0 < cos a) by (apply cos_gt_0; lra).
  assert (Sa : 0 < sin a) by (apply sin_gt_0; lra).
  destruct (centre_along_bisector _ _ _ _ _ diag_orthonormal Hr Ca P Q) as [B G].
  specialize (G (Rgt_not_eq _ _ Sa)).
  unfold diag_b, diag_g, dot in B, G; simpl in B, G.
  rewrite cos_plus, sin_plus, cos_PI4, sin_PI4 in B, G.
  assert (E2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (P2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (EI : 1 / sqrt 2 = sqrt 2 / 2) by (apply Rmult_eq_reg_r with (sqrt 2); [|lra]; field_simplify; lra).
  rewrite EI in B, G. pose proof cos_lambda_ge as CL.
  pose proof (sin2_cos2 lambda) as EL. unfold Rsqr in EL.
  set (q := sqrt 2) in *. set (cl := cos lambda) in *. set (sl := sin lambda) in *.
  set (X := vx c + vy c). set (Y := vy c - vx c).
  assert (B' : q / 2 * (X * cl + Y * sl) = r / (2 * cos a)).
  { rewrite <- B. unfold X, Y. ring. }
  assert (G' : q / 2 * (Y * cl - X * sl) = 0).
  { rewrite <- G. unfold X, Y. ring. }
  (* q/2 X = cl (r / 2 cos a), and cl >= cos a *)
  assert (K : q / 2 * X = cl * (r / (2 * cos a))).
  { replace (q / 2 * X) with (cl * (q / 2 * (X * cl + Y * sl)) - sl * (q / 2 * (Y * cl - X * sl))
      + q / 2 * X * (1 - (sl * sl + cl * cl))) by ring. rewrite B', G', EL. ring. }
  assert (M : cos a * (r / (2 * cos a)) = r / 2) by (field; lra).
  assert (0 < r / (2 * cos a)) by (apply Rdiv_lt_0_compat; lra).
  assert (cos a * (r / (2 * cos a)) <= cl * (r / (2 * cos a))) by (apply Rmult_le_compat_r; lra).
  fold X. nra.
Qed.

(** Edge directions (1, 1, z/n) with z = +1/20 (edge 03) and -14/10 (edge 04). *)
Definition dir z := let l := sqrt (2 + z * z) in Vec (1 / l) (1 / l) (z / l).

Lemma dir_unit z : norm2 (dir z) = 1.
Proof.
  unfold norm2, dot, dir; simpl.
  assert (S : sqrt (2 + z * z) * sqrt (2 + z * z) = 2 + z * z) by (apply sqrt_sqrt; nra).
  assert (P : 0 < sqrt (2 + z * z)) by (apply sqrt_lt_R0; nra).
  set (l := sqrt (2 + z * z)) in *. transitivity ((2 + z * z) / (l * l)); [field; lra|rewrite S; field; nra].
Qed.

(** The heart of W3: c outside both means two incompatible bounds on the height of c. *)
Lemma no_empty_sphere z3 z4 c : 0 < z3 -> z4 < 0 ->
  (* cos beta (l3/z3 + l4/|z4|) < sqrt 2 (1/z3 + 1/|z4|) without divisions *)
  cos beta * (sqrt (2 + z3 * z3) * - z4 + sqrt (2 + z4 * z4) * z3) < sqrt 2 * (z3 - z4) ->
  dist2 c vzero = dist2 c (spoke_start diag_b diag_g r a) ->
  dist2 c vzero = dist2 c (spoke_end diag_b diag_g r a) ->
  inside_at_origin c (cap_point r beta (dir z3)) \/ inside_at_origin c (cap_point r beta (dir z4)).
Proof.
  intros H3 H4 K P Q. pose proof (centre_diagonal c P Q) as D.
  assert (Cb : 0 < cos beta) by (apply cos_gt_0; lra).
  assert (E2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
  assert (P2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
  assert (F : forall z, r * cos beta * sqrt (2 + z * z) < 2 * (vx c + vy c + z * vz c) ->
                 inside_at_origin c (cap_point r beta (dir z))).
  { intros z L. apply inside_at_origin_iff. unfold cap_point.
    assert (S : sqrt (2 + z * z) * sqrt (2 + z * z) = 2 + z * z) by (apply sqrt_sqrt; nra).
    assert (PL : 0 < sqrt (2 + z * z)) by (apply sqrt_lt_R0; nra).
    pose proof (dir_unit z) as U. unfold norm2 in U |- *. rewrite dot_scale_l, !dot_scale_r, U.
    unfold dir, dot; simpl. set (l := sqrt (2 + z * z)) in *.
    replace (2 * (r * cos beta * (vx c * (1 / l) + vy c * (1 / l) + vz c * (z / l))))
      with (r * cos beta * (2 * (vx c + vy c + z * vz c) / l)) by (field; lra).
    assert (0 < r * cos beta) by nra.
    rewrite Rmult_1_r. apply Rmult_lt_compat_l; [assumption|].
    apply Rmult_lt_reg_r with l; [lra|].
    replace (2 * (vx c + vy c + z * vz c) / l * l) with (2 * (vx c + vy c + z * vz c)) by (field; lra).
    exact L. }
  set (X := vx c + vy c) in *. set (t := vz c) in *.
  set (l3 := sqrt (2 + z3 * z3)) in *. set (l4 := sqrt (2 + z4 * z4)) in *.
  destruct (Rlt_le_dec (r * cos beta * l3) (2 * (X + z3 * t))) as [L|L3]; [left; apply F; exact L|].
  destruct (Rlt_le_dec (r * cos beta * l4) (2 * (X + z4 * t))) as [L|L4]; [right; apply F; exact L|].
  exfalso.
  (* add -z4 times the first and z3 times the second: t cancels *)
  assert (A3 : - z4 * (2 * (X + z3 * t)) <= - z4 * (r * cos beta * l3)) by (apply Rmult_le_compat_l; lra).
  assert (A4 : z3 * (2 * (X + z4 * t)) <= z3 * (r * cos beta * l4)) by (apply Rmult_le_compat_l; lra).
  assert (S : 2 * X * (z3 - z4) <= r * (cos beta * (l3 * - z4 + l4 * z3))) by lra.
  assert (S2 : r * (cos beta * (l3 * - z4 + l4 * z3)) < r * (sqrt 2 * (z3 - z4))) by (apply Rmult_lt_compat_l; lra).
  assert (S3 : sqrt 2 * r <= 2 * X).
  { apply Rle_trans with (sqrt 2 * (sqrt 2 * X)); [apply Rmult_le_compat_l; lra|]. right.
    rewrite <- Rmult_assoc, E2. ring. }
  assert (0 < z3 - z4) by lra.
  assert (sqrt 2 * r * (z3 - z4) <= 2 * X * (z3 - z4)) by (apply Rmult_le_compat_r; lra).
  lra.
Qed.
End DiagonalEdges.

(** The directions are those of the edges 03 and 04 of W3. *)
Lemma w3_direction : w3 = vscale (20 * sqrt (2 + 1/20 * (1/20))) (dir (1/20)).
Proof.
  assert (PL : 0 < sqrt (2 + 1/20 * (1/20))) by (apply sqrt_lt_R0; lra).
  apply vec_eq; unfold dir, w3, vscale; simpl; field; lra.
Qed.
Lemma w4_direction : w4 = vscale (10 * sqrt (2 + (-14/10) * (-14/10))) (dir (-14/10)).
Proof.
  assert (PL : 0 < sqrt (2 + (-14/10) * (-14/10))) by (apply sqrt_lt_R0; lra).
  apply vec_eq; unfold dir, w4, vscale; simpl; field; lra.
Qed.

Lemma norm_scaled_dir k z : 0 < k -> norm (vscale k (dir z)) = k.
Proof.
  intros Hk. rewrite norm_scale. unfold norm. rewrite dir_unit, sqrt_1, Rabs_pos_eq; lra.
Qed.
Definition unit_of v := vscale (/ norm v) v.
Lemma unit_of_scaled_dir k z : 0 < k -> unit_of (vscale k (dir z)) = dir z.
Proof.
  intros Hk. unfold unit_of. rewrite norm_scaled_dir by exact Hk.
  destruct (dir z) as [x y t]. apply vec_eq; unfold vscale; simpl; field; lra.
Qed.
Lemma w3_unit : unit_of w3 = dir (1/20).
Proof.
  rewrite w3_direction at 1. apply unit_of_scaled_dir.
  assert (0 < sqrt (2 + 1/20 * (1/20))) by (apply sqrt_lt_R0; lra). lra.
Qed.
Lemma w4_unit : unit_of w4 = dir (-14/10).
Proof.
  rewrite w4_direction at 1. apply unit_of_scaled_dir.
  assert (0 < sqrt (2 + (-14/10) * (-14/10))) by (apply sqrt_lt_R0; lra). lra.
Qed.

(** The point of face 012 on the protecting circle at angle t from edge 01. *)
Definition arc_point r t := Vec (r * cos t) (r * sin t) 0.

(** No sphere through the vertices of the spoke (0, p, q) is empty of the two points. *)
Definition no_empty_sphere_through_spoke r beta t1 t2 :=
  forall c, dist2 c w0 = dist2 c (arc_point r t1) -> dist2 c w0 = dist2 c (arc_point r t2) ->
    strictly_inside c w0 (cap_point r beta (unit_of w3)) \/
    strictly_inside c w0 (cap_point r beta (unit_of w4)).

Lemma w3_spoke beta r t1 t2 : 0 < beta < PI / 2 -> cos beta <= 982 / 1000 -> 0 < r ->
  0 <= t1 <= PI / 4 -> PI / 4 <= t2 <= PI / 2 -> t1 < t2 ->
  no_empty_sphere_through_spoke r beta t1 t2.
Proof.
  intros Hb Cb Hr H1 H2 H12 c P Q. pose proof PI_RGT_0.
  set (a := (t2 - t1) / 2). set (lambda := (t1 + t2) / 2 - PI / 4).
  rewrite w3_unit, w4_unit.
  assert (EP : arc_point r t1 = spoke_start (diag_b lambda) (diag_g lambda) r a).
  { replace t1 with (PI / 4 + lambda + - a) by (unfold a, lambda; field).
    apply vec_eq; unfold arc_point, spoke_start, in_face, diag_b, diag_g, vadd, vscale; simpl;
      rewrite ?(cos_plus (PI / 4 + lambda)), ?(sin_plus (PI / 4 + lambda)); ring. }
  assert (EQ : arc_point r t2 = spoke_end (diag_b lambda) (diag_g lambda) r a).
  { replace t2 with (PI / 4 + lambda + a) by (unfold a, lambda; field).
    apply vec_eq; unfold arc_point, spoke_end, in_face, diag_b, diag_g, vadd, vscale; simpl;
      rewrite ?(cos_plus (PI / 4 + lambda)), ?(sin_plus (PI / 4 + lambda)); ring. }
  rewrite EP in P. rewrite EQ in Q.
  change w0 with vzero in P, Q |- *.
  apply (no_empty_sphere r a lambda beta); try assumption; try (unfold a, lambda; lra).
  (* the numbers: l3 = sqrt 2.0025, l4 = sqrt 3.96 *)
  assert (L3 : sqrt (2 + 1/20 * (1/20)) <= 14151 / 10000).
  { apply sq_le; [lra|]. rewrite sqrt_sqrt; lra. }
  assert (L4 : sqrt (2 + (-14/10) * (-14/10)) <= 199 / 100).
  { apply sq_le; [lra|]. rewrite sqrt_sqrt; lra. }
  assert (L2 : 1414 / 1000 <= sqrt 2).
  { apply sq_le; [apply sqrt_pos|]. rewrite sqrt_sqrt; lra. }
  assert (0 < cos beta) by (apply cos_gt_0; lra).
  set (l3 := sqrt (2 + 1/20 * (1/20))) in *. set (l4 := sqrt (2 + (-14/10) * (-14/10))) in *.
  assert (cos beta * (l3 * - (-14/10) + l4 * (1/20)) <= cos beta * (20807 / 10000))
    by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(** Somewhere an increasing sequence of angles passes the one below the edges. *)
Lemma straddling (s : nat -> R) m k : s 0%nat <= m -> m <= s k -> (0 < k)%nat ->
  exists i, (i < k)%nat /\ s i <= m <= s (S i).
Proof.
  intros S0. induction k as [|k IH]; intros Sk Hk; [inversion Hk|].
  destruct (Rle_lt_dec m (s k)) as [L|L].
  - destruct k as [|k]; [exists 0%nat; split; [auto|lra]|].
    destruct IH as (i & I & J); [exact L|apply PeanoNat.Nat.lt_0_succ|]. exists i. split; [auto|exact J].
  - exists k. split; [auto|lra].
Qed.

(** LG, the machine-checked refutation of the published rule. phi is W3's phi
    ([W3_phi]); beta is any angle from phi/4 up to pi/4, phi/3 and phi/4 among them; the
    remaining arc of face 012, from beta to pi/2 - beta, is subdivided in ANY way.
    Then some spoke triangle of face 012 has no empty sphere through its vertices. *)
Theorem W3_literal_rule_fails phi beta r k (s : nat -> R) :
  0 < phi < PI / 2 -> cos phi * cos phi = 50 / 99 -> phi / 4 <= beta <= PI / 4 ->
  0 < r -> (0 < k)%nat -> s 0%nat = beta -> s k = PI / 2 - beta ->
  (forall i, (i < k)%nat -> s i < s (S i)) -> (forall i, (i <= k)%nat -> beta <= s i <= PI / 2 - beta) ->
  exists i, (i < k)%nat /\ no_empty_sphere_through_spoke r beta (s i) (s (S i)).
Proof.
  intros Hp C Hb Hr Hk S0 Sk Inc Rng. pose proof PI_RGT_0.
  destruct (straddling s (PI / 4) k) as (i & I & J1 & J2); [lra|lra|exact Hk|].
  exists i. split; [exact I|].
  pose proof (Inc i I). pose proof (Rng i (PeanoNat.Nat.lt_le_incl _ _ I)). pose proof (Rng (S i) I).
  apply w3_spoke; try lra.
  apply Rle_trans with (cos (phi / 4)); [apply cos_decr_1; lra|].
  apply cos_quarter; [lra|exact C].
Qed.

(** With beta = phi/3 and with beta = phi/4. *)
Corollary W3_phi_third phi r t1 t2 : 0 < phi < PI / 2 -> cos phi * cos phi = 50 / 99 -> 0 < r ->
  0 <= t1 <= PI / 4 -> PI / 4 <= t2 <= PI / 2 -> t1 < t2 ->
  no_empty_sphere_through_spoke r (phi / 3) t1 t2.
Proof.
  intros Hp C Hr H1 H2 H12. pose proof PI_RGT_0. apply w3_spoke; try lra.
  apply Rle_trans with (cos (phi / 4)); [apply cos_decr_1; lra|apply cos_quarter; [lra|exact C]].
Qed.
Corollary W3_phi_quarter phi r t1 t2 : 0 < phi < PI / 2 -> cos phi * cos phi = 50 / 99 -> 0 < r ->
  0 <= t1 <= PI / 4 -> PI / 4 <= t2 <= PI / 2 -> t1 < t2 ->
  no_empty_sphere_through_spoke r (phi / 4) t1 t2.
Proof.
  intros Hp C Hr H1 H2 H12. pose proof PI_RGT_0. apply w3_spoke; try lra.
  apply cos_quarter; [lra|exact C].
Qed.

(** ** G3: the same with faces that share only a vertex *)

(** Vertices 0, 1, 2, 3 as in W3, (0,0,28), (10,10,-14), (-10,-10,-14); triangles 012,
    034, 056. The obstructing edges are 03 and 05, whose directions are those of
    W3's 03 and 04: [W3_literal_rule_fails] applies word for word once phi is the same. *)
Definition g4 := Vec 0 0 28.
Definition g5 := Vec 10 10 (-14).
Definition g6 := Vec (-10) (-10) (-14).
Definition g3_edge_pairs : list (vec * vec * vec) :=
  [ (w0,w1,w2); (w0,w1,w3); (w0,w1,g4); (w0,w1,g5); (w0,w1,g6); (w0,w2,w3); (w0,w2,g4); (w0,w2,g5);
    (w0,w2,g6); (w0,w3,g4); (w0,w3,g5); (w0,w3,g6); (w0,g4,g5); (w0,g4,g6); (w0,g5,g6);
    (w1,w0,w2); (w2,w0,w1); (w3,w0,g4); (g4,w0,w3); (g5,w0,g6); (g6,w0,g5) ].
Theorem G3_phi : (forall t, In t g3_edge_pairs -> angle_cos2_le (50 / 99) t) /\
  angle_cos2_eq (50 / 99) (g5, w0, g6) /\ g5 = w4.
Proof.
  split; [|split; [|reflexivity]].
  - intros t H. unfold g3_edge_pairs in H. simpl in H.
    repeat match goal with H : _ \/ _ |- _ => destruct H as [H|H] end; try contradiction; subst t;
      unfold angle_cos2_le, norm2, dot, vsub, w0, w1, w2, w3, g4, g5, g6; simpl; lra.
  - unfold angle_cos2_eq, norm2, dot, vsub, w0, g5, g6; simpl; lra.
Qed.
