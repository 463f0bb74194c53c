(** L9, L10, L11: the T and S cells at a vertex against the other points there (paper
    section 3.2: "the points inside the buffer-zones do not interfere with each other;
    their minimum diameter circumspheres cannot intersect because of the spherical and
    cylindrical distributions"; read: the spheres are empty).

    The vertex is the origin. *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space EdgeFaceAngle.
Open Scope R_scope.

(** ** T = (v, m, a): right angle at m, so its sphere has diameter va *)

Definition T_power a x := power (vscale (1 / 2) a) vzero x.

(** The form of L9: power = x.(x - a). *)
Lemma T_power_eq a x : T_power a x = dot x (vsub x a).
Proof. unfold T_power. destruct a, x. unfold power, dist2, norm2, dot, vsub, vscale, vzero; simpl. field. Qed.

Lemma T_power_half a x : T_power a x = (norm2 x + dist2 x a - norm2 a) / 2.
Proof. rewrite T_power_eq. destruct a, x. unfold dist2, norm2, dot, vsub; simpl. field. Qed.

(** Corners: v, a and m = (r cos beta) u are on the sphere. *)
Theorem T_corners r beta u o : norm2 u = 1 -> norm2 o = 1 -> dot u o = 0 ->
  let m := vscale (r * cos beta) u in
  let a := vadd m (vscale (r * sin beta) o) in
  T_power a vzero = 0 /\ T_power a m = 0 /\ T_power a a = 0 /\ norm2 a = r * r.
Proof.
  intros U O UO m a. rewrite !T_power_eq. unfold a, m, norm2 in *.
  rewrite !dot_sub_r, !dot_add_r, !dot_add_l, !dot_scale_r, !dot_scale_l, !dot_zero_l.
  rewrite (dot_comm o u), U, O, UO. pose proof (sin2_cos2 beta) as E. unfold Rsqr in E.
  repeat split; try ring.
  replace (r * cos beta * (r * cos beta * 1) + r * cos beta * (r * sin beta * 0) +
    (r * sin beta * (r * cos beta * 0) + r * sin beta * (r * sin beta * 1)))
    with (r * r * (sin beta * sin beta + cos beta * cos beta)) by ring.
  rewrite E. ring.
Qed.

(** L9 against points that are not on an edge at v: they are at distance >= r from v,
    and the sphere touches that ball only at a. *)
Theorem T_vs_points_outside_ball a r x : norm2 a = r * r -> r * r <= norm2 x ->
  dist2 x a / 2 <= T_power a x.
Proof. intros A X. rewrite T_power_half. lra. Qed.

Corollary T_vs_points_outside_ball_strict a r x : norm2 a = r * r -> r * r <= norm2 x -> x <> a ->
  0 < T_power a x.
Proof.
  intros A X N. pose proof (T_vs_points_outside_ball a r x A X).
  destruct (Rle_lt_or_eq_dec 0 (dist2 x a) (dist2_nonneg x a)) as [L|E]; [lra|].
  exfalso. apply N. symmetry in E. apply norm2_zero in E.
  destruct x, a. unfold vsub, vzero in E; simpl in E. injection E. intros. f_equal; lra.
Qed.

(** L9 against points s u' of edges e' at v, s >= r cos beta: enough that e' makes an
    angle of at least beta with a. *)
Theorem T_vs_edge_points a r beta u s : norm2 u = 1 -> 0 < s -> r * cos beta <= s ->
  dot u a <= r * cos beta -> 0 <= T_power a (vscale s u).
Proof.
  unfold norm2. intros U S0 S A. rewrite T_power_eq, dot_sub_r, !dot_scale_l, !dot_scale_r, U. nra.
Qed.

Theorem T_vs_edge_points_strict a r beta u s : norm2 u = 1 -> 0 < s -> r * cos beta <= s ->
  dot u a <= r * cos beta -> (dot u a < r * cos beta \/ r * cos beta < s) -> 0 < T_power a (vscale s u).
Proof.
  unfold norm2. intros U S0 S A D. rewrite T_power_eq, dot_sub_r, !dot_scale_l, !dot_scale_r, U.
  assert (0 < s - dot u a) by (destruct D; lra).
  replace (s * (s * 1) - s * dot u a) with (s * (s - dot u a)) by ring.
  apply Rmult_lt_0_compat; assumption.
Qed.

(** ** S = (v, p, q): unit bisector b, half-angle a *)

(** L10 against edge points is EdgeFaceAngle.edge_face_clear: the angle between b and e'
    is at least phi* for an edge off F and at least a + beta for an edge of F. *)
Theorem S_vs_own_edges b r a beta u s : norm2 b = 1 -> norm2 u = 1 -> 0 < r ->
  0 < a < PI / 2 -> 0 < beta < PI / 2 -> dot b u <= cos (a + beta) ->
  r * cos beta <= s -> 0 < s -> 0 < spoke_power b r a (vscale s u).
Proof.
  intros B U Hr Ha Hb A Hs S0. pose proof PI_RGT_0.
  assert (0 < sin a) by (apply sin_gt_0; lra). assert (0 < sin beta) by (apply sin_gt_0; lra).
  apply edge_face_clear_strict with (beta := beta) (phi := a + beta); try assumption.
  - apply cos_gt_0; lra.
  - rewrite cos_plus. nra.
Qed.

(** L11 against any point outside the ball whose direction is not within the spoke. *)
Theorem S_vs_directions_outside b r a x : norm2 b = 1 -> 0 < r -> 0 < cos a ->
  r * r <= norm2 x -> dot b x <= norm x * cos a -> 0 <= spoke_power b r a x.
Proof.
  intros B Hr Ca X D. rewrite spoke_power_eq by (assumption || lra).
  pose proof (norm_sqr x) as NX. pose proof (norm_nonneg x) as N0. rewrite <- NX in X |- *.
  assert (r <= norm x) by (apply sq_le; assumption).
  assert (dot b x / cos a <= norm x).
  { apply Rmult_le_reg_r with (cos a); [lra|]. replace (dot b x / cos a * cos a) with (dot b x) by (field; lra). lra. }
  replace (r / cos a * dot b x) with (r * (dot b x / cos a)) by (field; lra). nra.
Qed.

(** L11 against points beyond the sphere's reach r / cos a. *)
Theorem S_vs_far b r a x : norm2 b = 1 -> 0 < r -> 0 < cos a ->
  r < norm x * cos a -> 0 < spoke_power b r a x.
Proof.
  intros B Hr Ca X. rewrite spoke_power_eq by (assumption || lra).
  pose proof (norm_sqr x) as NX. pose proof (norm_nonneg x) as N0.
  pose proof (cauchy_schwarz b x) as CS. pose proof (norm_sqr b) as NB. rewrite B in NB.
  assert (NB1 : norm b = 1) by (pose proof (norm_nonneg b); nra). rewrite NB1 in CS.
  rewrite <- NX.
  assert (Q : 0 < r / cos a) by (apply Rdiv_lt_0_compat; lra).
  assert (E : r / cos a * cos a = r) by (field; lra). set (k := r / cos a) in *.
  assert (k < norm x) by nra. nra.
Qed.

(** Outside the ball, the sphere of S stays within the chord of a/2 ... from the
    middle r b of the arc: points of other faces, 1.5 h away, are never inside. *)
Theorem S_vs_far_from_arc b r a x : norm2 b = 1 -> 0 < r -> 1 / 2 <= cos a ->
  r * r <= norm2 x -> 2 * r * r * (1 - cos a) < dist2 x (vscale r b) -> 0 < spoke_power b r a x.
Proof.
  intros B Hr Ca X D. rewrite spoke_power_eq by (assumption || lra).
  assert (E : dist2 x (vscale r b) = norm2 x + r * r * norm2 b - 2 * r * dot b x) by vring.
  rewrite E, B in D. set (X2 := norm2 x) in *. set (k := dot b x) in *.
  assert (K : 2 * r * k < X2 - r * r + 2 * r * r * cos a) by lra.
  apply Rmult_lt_reg_l with (2 * cos a); [lra|]. rewrite Rmult_0_r.
  replace (2 * cos a * (X2 - r / cos a * k)) with (2 * cos a * X2 - 2 * r * k) by (field; lra).
  nra.
Qed.

(** 2 r sin(a/2) is at most the chord's half: in terms of the chord c = 2 r sin a,
    2 r^2 (1 - cos a) <= c^2 / 3.4 for cos a >= 0.7. *)
Lemma arc_middle_reach r a : 7 / 10 <= cos a ->
  34 / 10 * (2 * r * r * (1 - cos a)) <= (2 * r * sin a) * (2 * r * sin a).
Proof.
  intros C. pose proof (sin2_cos2 a) as E. unfold Rsqr in E. pose proof (COS_bound a).
  replace (2 * r * sin a * (2 * r * sin a)) with (4 * (r * r) * (1 - cos a * cos a)) by (rewrite <- E; ring).
  assert (0 <= r * r) by nra. assert (0 <= (1 - cos a) * (4 * (1 + cos a) - 68 / 10)) by nra.
  assert (0 <= r * r * ((1 - cos a) * (4 * (1 + cos a) - 68 / 10))) by nra. nra.
Qed.

(** L11 against the protector of a neighbouring edge e of the same face: its points
    are a + lambda u, lambda >= 0. *)
Theorem S_vs_protector b r a beta u av lambda : norm2 b = 1 -> norm2 u = 1 -> 0 < r ->
  0 < a < PI / 2 -> 0 < beta < PI / 2 -> norm2 av = r * r -> dot u av = r * cos beta ->
  dot b av <= r * cos a -> dot b u <= cos (a + beta) -> 0 <= lambda ->
  0 <= spoke_power b r a (vadd av (vscale lambda u)) /\
  (0 < lambda -> 0 < spoke_power b r a (vadd av (vscale lambda u))).
Proof.
  intros B U Hr Ha Hb A UA BA BU L. pose proof PI_RGT_0.
  assert (Ca : 0 < cos a) by (apply cos_gt_0; lra).
  assert (Cb : 0 < cos beta) by (apply cos_gt_0; lra).
  assert (0 < sin a) by (apply sin_gt_0; lra). assert (0 < sin beta) by (apply sin_gt_0; lra).
  rewrite cos_plus in BU. rewrite spoke_power_eq by (assumption || lra).
  replace (norm2 (vadd av (vscale lambda u))) with (norm2 av + 2 * lambda * dot u av + lambda * lambda * norm2 u) by vring.
  rewrite dot_add_r, dot_scale_r, A, UA, U.
  assert (K1 : dot b av / cos a <= r).
  { apply Rmult_le_reg_r with (cos a); [lra|]. replace (dot b av / cos a * cos a) with (dot b av) by (field; lra). lra. }
  assert (K2 : dot b u / cos a <= cos beta).
  { apply Rmult_le_reg_r with (cos a); [lra|]. replace (dot b u / cos a * cos a) with (dot b u) by (field; lra). nra. }
  replace (r / cos a * (dot b av + lambda * dot b u)) with (r * (dot b av / cos a) + lambda * r * (dot b u / cos a)) by (field; lra).
  assert (r * (dot b av / cos a) <= r * r) by (apply Rmult_le_compat_l; lra).
  assert (lambda * r * (dot b u / cos a) <= lambda * r * cos beta) by (apply Rmult_le_compat_l; [nra|lra]).
  assert (0 <= lambda * r * cos beta) by (apply Rmult_le_pos; [nra|lra]).
  split; [nra|]. intros L0. assert (0 < lambda * lambda) by nra. nra.
Qed.

(** L11 against Chew points of the same face (paper section 2.2: "Thus Chew's triangles
    are protected from the circumcircles of the spoke triangles"): a point outside the
    ball and inside the sphere is within the bulge of the chord pq. *)
Theorem S_reach b g r a X Y : orthonormal2 b g -> 0 < r -> 0 < a <= PI / 4 ->
  let x := vadd (vscale X b) (vscale Y g) in
  r * r <= norm2 x -> spoke_power b r a x <= 0 ->
  exists t, 0 <= t <= 1 /\
    dist2 x (along (spoke_start b g r a) (spoke_end b g r a) t)
    <= (r / cos a - r * cos a) * (r / cos a - r * cos a).
Proof.
  intros O Hr Ha x NX SP. pose proof PI_RGT_0. destruct O as (B & G & BG).
  assert (Ca : 0 < cos a) by (apply cos_gt_0; lra).
  assert (Sa : 0 < sin a) by (apply sin_gt_0; lra).
  assert (SC : sin a <= cos a).
  { apply Rle_trans with (sin (PI / 4)); [apply sin_incr_1; lra|].
    rewrite sin_PI4, <- cos_PI4. apply cos_decr_1; lra. }
  pose proof (sin2_cos2 a) as E. unfold Rsqr in E.
  rewrite spoke_power_eq in SP by (assumption || lra).
  assert (EX : norm2 x = X * X + Y * Y).
  { unfold x, norm2 in *. rewrite !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r, (dot_comm g b), B, G, BG. ring. }
  assert (EB : dot b x = X).
  { unfold x, norm2 in *. rewrite dot_add_r, !dot_scale_r, B, BG. ring. }
  rewrite EX in NX, SP. rewrite EB in SP.
  assert (K : (X * X + Y * Y) * cos a <= r * X).
  { apply Rmult_le_compat_r with (r := cos a) in SP; [|lra].
    replace ((X * X + Y * Y - r / cos a * X) * cos a) with ((X * X + Y * Y) * cos a - r * X) in SP by (field; lra). lra. }
  set (c := cos a) in *. set (s := sin a) in *.
  assert (X1 : r * c <= X) by nra.
  assert (X2 : X <= r / c).
  { apply Rmult_le_reg_r with c; [lra|]. replace (r / c * c) with r by (field; lra).
    apply Rmult_le_reg_r with X; nra. }
  assert (Y2 : Y * Y <= (r * s) * (r * s)).
  { (* Y^2 <= X (r/c - X), decreasing beyond X = r/(2c) <= r c *)
    assert (Y * Y <= X * (r / c) - X * X).
    { apply Rmult_le_reg_r with c; [lra|].
      replace ((X * (r / c) - X * X) * c) with (X * r - X * X * c) by (field; lra). lra. }
    assert (Q : r / c = r * c + r * (s * s) / c).
    { replace (s * s) with (1 - c * c) by lra. field. lra. }
    assert (QQ : r * c * (r * (s * s) / c) = (r * s) * (r * s)) by (field; lra).
    assert (P : 0 <= (X - r * c) * (X - r * (s * s) / c)).
    { apply Rmult_le_pos; [lra|].
      assert (r * (s * s) / c <= r * c).
      { apply Rmult_le_reg_r with c; [lra|]. replace (r * (s * s) / c * c) with (r * (s * s)) by (field; lra).
        rewrite Rmult_assoc. apply Rmult_le_compat_l; [lra|]. apply sq_le_mono; lra. }
      lra. }
    rewrite Q in H0. clear - H0 P QQ. set (m := r * (s * s) / c) in *. nra. }
  assert (RS : 0 < r * s) by (apply Rmult_lt_0_compat; assumption).
  assert (Yr : - (r * s) <= Y <= r * s).
  { clear - Y2 RS. set (m := r * s) in *. split; nra. }
  exists ((Y + r * s) / (2 * (r * s))).
  split.
  - split.
    + apply Rmult_le_reg_r with (2 * (r * s)); [lra|]. rewrite Rmult_0_l.
      replace ((Y + r * s) / (2 * (r * s)) * (2 * (r * s))) with (Y + r * s) by (field; split; lra). lra.
    + apply Rmult_le_reg_r with (2 * (r * s)); [lra|].
      replace ((Y + r * s) / (2 * (r * s)) * (2 * (r * s))) with (Y + r * s) by (field; split; lra). lra.
  - set (t := (Y + r * s) / (2 * (r * s))).
    assert (T : 2 * (r * s) * t = Y + r * s) by (unfold t; field; split; lra).
    replace (along (spoke_start b g r a) (spoke_end b g r a) t) with (vadd (vscale (r * c) b) (vscale Y g)).
    + replace (vsub x (vadd (vscale (r * c) b) (vscale Y g))) with (vscale (X - r * c) b) by (unfold x; veq).
      unfold dist2. replace (vsub x (vadd (vscale (r * c) b) (vscale Y g))) with (vscale (X - r * c) b) by (unfold x; veq).
      unfold norm2 in *. rewrite dot_scale_l, dot_scale_r, B.
      assert (0 <= X - r * c <= r / c - r * c) by lra.
      replace ((X - r * c) * ((X - r * c) * 1)) with ((X - r * c) * (X - r * c)) by ring.
      apply sq_le_mono; lra.
    + replace Y with (2 * (r * s) * t - r * s) by lra.
      unfold spoke_start, spoke_end, in_face. rewrite cos_neg, sin_neg. fold c s. unfold along. veq.
Qed.
