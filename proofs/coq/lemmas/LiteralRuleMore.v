(** LG, the other two counterexamples of theory.md section 2: the 2D protectors that
    cross, and W2 (4 vertices, 2 triangles): the claim about diametral spheres fails. *)
From Coq Require Import Reals Lra Psatz List.
From Confidel.lemmas Require Import Space EdgeFaceAngle LiteralRule.
Import ListNotations.
Open Scope R_scope.

(** ** 2D: d_e at its maximum *)

(** Right isosceles corner: v = 0, edges along 0 and 45 degrees, phi = pi/4. Section 2.3:
    d_e "can be computed in the same manner h is computed", and h may be as large as
    2 r sin(phi/4) = r sin(beta). Then beta > phi/2 (the protectors cross, L5), and m
    of the second edge is strictly inside the diametral circle of (v, m, a). *)
Theorem literal_2D_protectors_cross r beta : 0 < r -> 0 < beta < PI / 4 ->
  r * sin beta = 2 * r * sin (PI / 4 / 4) ->
  PI / 4 / 2 < beta /\
  let a_plus := Vec (r * cos beta) (r * sin beta) 0 in
  let m_B := Vec (r * cos beta * cos (PI / 4)) (r * cos beta * sin (PI / 4)) 0 in
  strictly_inside (vscale (1 / 2) a_plus) vzero m_B.
Proof.
  intros Hr Hb E. pose proof PI_RGT_0.
  assert (S : sin beta = 2 * sin (PI / 4 / 4)).
  { apply Rmult_eq_reg_l with r; lra. }
  assert (B : PI / 4 / 2 < beta).
  { assert (sin (PI / 4 / 2) < sin beta).
    { rewrite S. replace (PI / 4 / 2) with (2 * (PI / 4 / 4)) by field. rewrite sin_2a.
      assert (0 < sin (PI / 4 / 4)) by (apply sin_gt_0; lra).
      assert (cos (PI / 4 / 4) < cos 0) by (apply cos_decreasing_1; lra). rewrite cos_0 in *. nra. }
    destruct (Rlt_le_dec (PI / 4 / 2) beta); [assumption|].
    assert (sin beta <= sin (PI / 4 / 2)) by (apply sin_incr_1; lra). lra. }
  split; [exact B|]. intros a_plus m_B. unfold strictly_inside.
  assert (C0 : 0 < cos beta) by (apply cos_gt_0; lra).
  assert (C : cos beta < cos (PI / 4 - beta)) by (apply cos_decreasing_1; lra).
  rewrite cos_minus in C.
  pose proof (sin2_cos2 (PI / 4)) as Q. unfold Rsqr in Q.
  set (c := cos (PI / 4)) in *. set (s := sin (PI / 4)) in *.
  set (cb := cos beta) in *. set (sb := sin beta) in *.
  replace (power (vscale (1 / 2) a_plus) vzero m_B)
    with (r * cb * (r * cb * (s * s + c * c) - r * (c * cb + s * sb))) by (subst a_plus m_B; unfold power, dist2, norm2, dot, vsub, vscale, vzero; simpl; field).
  rewrite Q. assert (0 < r * cb) by nra.
  assert (r * cb * 1 - r * (c * cb + s * sb) < 0) by nra. nra.
Qed.

(** At beta = phi/3 the same pair is safe. *)
Theorem repaired_2D_protectors r : 0 < r ->
  let beta := PI / 4 / 3 in
  let a_plus := Vec (r * cos beta) (r * sin beta) 0 in
  let m_B := Vec (r * cos beta * cos (PI / 4)) (r * cos beta * sin (PI / 4)) 0 in
  0 < power (vscale (1 / 2) a_plus) vzero m_B.
Proof.
  intros Hr beta a_plus m_B. pose proof PI_RGT_0.
  assert (C0 : 0 < cos beta) by (apply cos_gt_0; unfold beta; lra).
  assert (C : cos (PI / 4 - beta) < cos beta) by (apply cos_decreasing_1; unfold beta; lra).
  rewrite cos_minus in C.
  pose proof (sin2_cos2 (PI / 4)) as Q. unfold Rsqr in Q.
  set (c := cos (PI / 4)) in *. set (s := sin (PI / 4)) in *.
  set (cb := cos beta) in *. set (sb := sin beta) in *.
  replace (power (vscale (1 / 2) a_plus) vzero m_B)
    with (r * cb * (r * cb * (s * s + c * c) - r * (c * cb + s * sb))) by (subst a_plus m_B; unfold power, dist2, norm2, dot, vsub, vscale, vzero; simpl; field).
  rewrite Q. assert (0 < r * cb) by nra.
  assert (0 < r * cb * 1 - r * (c * cb + s * sb)) by nra. nra.
Qed.

(** ** W2 *)

(** (0,0,0) (12,0,0) (0,12,0) (12,12,1); triangles 012 and 013. *)
Definition u1 := Vec 12 0 0.
Definition u2 := Vec 0 12 0.
Definition u3 := Vec 12 12 1.
Definition w2_edge_pairs : list (vec * vec * vec) :=
  [ (w0,u1,u2); (w0,u1,u3); (w0,u2,u3); (u1,w0,u2); (u1,w0,u3); (u1,u2,u3); (u2,w0,u1); (u3,w0,u1) ].
(** cos^2 phi = 145/289 (phi = 44.9 degrees), attained at vertex 3. *)
Theorem W2_phi : (forall t, In t w2_edge_pairs -> angle_cos2_le (145 / 289) t) /\
  In (u3, w0, u1) w2_edge_pairs /\ angle_cos2_eq (145 / 289) (u3, w0, u1).
Proof.
  split; [|split; [simpl; tauto|]].
  - intros t H. unfold w2_edge_pairs in H. simpl in H.
    repeat match goal with H : _ \/ _ |- _ => destruct H as [H|H] end; try contradiction; subst t;
      unfold angle_cos2_le, norm2, dot, vsub, w0, u1, u2, u3; simpl; lra.
  - unfold angle_cos2_eq, norm2, dot, vsub, w0, u1, u2, u3; simpl; lra.
Qed.

(** The paper's rule with any beta >= phi/4 (indeed with cos beta < 0.998, omega being
    3.4 degrees): every spoke of face 012 under edge 03 has m_{03} strictly inside
    its diametral sphere. *)
Theorem W2_diametral_spheres_fail r a lambda beta :
  0 < r -> 0 < a < PI / 2 -> - a <= lambda <= a -> 0 < beta < PI / 2 -> cos beta < 998 / 1000 ->
  strictly_inside (spoke_centre (diag_b lambda) r a) vzero (cap_point r beta (unit_of u3)).
Proof.
  intros Hr Ha Hl Hb Cb. pose proof PI_RGT_0.
  assert (PL : 0 < sqrt (2 + 1/12 * (1/12))) by (apply sqrt_lt_R0; lra).
  assert (U : unit_of u3 = dir (1/12)).
  { replace u3 with (vscale (12 * sqrt (2 + 1/12 * (1/12))) (dir (1/12))).
    - apply unit_of_scaled_dir. lra.
    - apply vec_eq; unfold dir, u3, vscale; simpl; field; lra. }
  assert (Ca : 0 < cos a) by (apply cos_gt_0; lra).
  assert (Cb0 : 0 < cos beta) by (apply cos_gt_0; lra).
  rewrite U. unfold strictly_inside.
  change (power (spoke_centre (diag_b lambda) r a) vzero) with (spoke_power (diag_b lambda) r a).
  rewrite spoke_power_on_edge; [|exact Ca|apply diag_orthonormal; exact lambda|apply dir_unit].
  assert (D : dot (diag_b lambda) (dir (1/12)) = cos lambda * (sqrt 2 / sqrt (2 + 1/12 * (1/12)))).
  { unfold diag_b, dir, dot; simpl. rewrite cos_plus, sin_plus, cos_PI4, sin_PI4.
    assert (P2 : 0 < sqrt 2) by (apply sqrt_lt_R0; lra).
    assert (E2 : sqrt 2 * sqrt 2 = 2) by (apply sqrt_sqrt; lra).
    set (l := sqrt (2 + 1/12 * (1/12))) in *. set (q := sqrt 2) in *.
    apply Rmult_eq_reg_r with (q * l); [|nra].
    transitivity (cos lambda * 2); [field; lra|rewrite <- E2; field; lra]. }
  rewrite D. pose proof (cos_lambda_ge a lambda Ha Hl) as CL.
  assert (Q : 998 / 1000 <= sqrt 2 / sqrt (2 + 1/12 * (1/12))).
  { rewrite <- sqrt_div by lra. apply sq_le; [apply sqrt_pos|]. rewrite sqrt_sqrt by lra. lra. }
  set (k := sqrt 2 / sqrt (2 + 1/12 * (1/12))) in *.
  assert (P : 0 < r * r * cos beta / cos a) by (apply Rdiv_lt_0_compat; [repeat apply Rmult_lt_0_compat|]; assumption).
  assert (cos beta * cos a < cos lambda * k) by nra. nra.
Qed.

(** The rational witness of theory.md: sin beta = 9/41, spoke (0, (4/5,3/5,0), (3/5,4/5,0)),
    centre (5/14, 5/14, 0), m' = (40/41)(12,12,1)/17. *)
Theorem W2_rational_witness :
  let p := Vec (4/5) (3/5) 0 in let q := Vec (3/5) (4/5) 0 in
  let c := Vec (5/14) (5/14) 0 in let m := vscale (40/41/17) u3 in
  dist2 c w0 = dist2 c p /\ dist2 c w0 = dist2 c q /\ norm2 u3 = 17 * 17 /\
  power c w0 m = - 6400 / 200039.
Proof.
  simpl. unfold power, dist2, norm2, dot, vsub, vscale, w0, u3; simpl. repeat split; field.
Qed.
