(** L12, L13: the R cells along an edge against the points at the same edge and at its
    ends (paper section 3.2: "cannot intersect because of the ... point alignment on the
    edges and edge-protectors, and edge spacing").

    The edge starts at the origin in the unit direction u; the rectangle has the corners
    x1 u, x2 u and their translates by d o, o the unit offset direction of its face.
    A point is written k u + y with y orthogonal to u. *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space DihedralGap.
Open Scope R_scope.

Definition R_centre u o d x1 x2 := vadd (vscale ((x1 + x2) / 2) u) (vscale (d / 2) o).
Definition R_power u o d x1 x2 x := power (R_centre u o d x1 x2) (vscale x1 u) x.

Lemma R_power_eq u o d x1 x2 k y : norm2 u = 1 -> dot u o = 0 -> dot u y = 0 ->
  R_power u o d x1 x2 (vadd (vscale k u) y) = (k - x1) * (k - x2) + dot y (vsub y (vscale d o)).
Proof.
  intros U O Y. unfold R_power, R_centre.
  replace (power (vadd (vscale ((x1 + x2) / 2) u) (vscale (d / 2) o)) (vscale x1 u) (vadd (vscale k u) y))
    with ((k - x1) * (k - x2) * norm2 u + norm2 y - d * dot y o
          + (2 * k - x1 - x2) * dot u y + (d * (x1 - k)) * dot u o).
  - rewrite U, O, Y, dot_sub_r, dot_scale_r. unfold norm2. ring.
  - destruct u, o, y. unfold power, dist2, norm2, dot, vsub, vadd, vscale; simpl. field.
Qed.

(** All four corners are on the sphere. *)
Theorem R_corners u o d x1 x2 : norm2 u = 1 -> norm2 o = 1 -> dot u o = 0 ->
  forall x, x = x1 \/ x = x2 ->
  R_power u o d x1 x2 (vadd (vscale x u) vzero) = 0 /\
  R_power u o d x1 x2 (vadd (vscale x u) (vscale d o)) = 0.
Proof.
  intros U O UO x H. rewrite !R_power_eq; try assumption; [|rewrite dot_scale_r; rewrite UO; ring|apply dot_zero_r].
  rewrite !dot_sub_r, !dot_scale_l, !dot_scale_r, !dot_zero_l. unfold norm2 in O. rewrite O.
  destruct H; subst; split; ring.
Qed.

Definition not_between x1 x2 k := k <= x1 \/ x2 <= k.
Lemma not_between_pos x1 x2 k : x1 <= x2 -> not_between x1 x2 k -> 0 <= (k - x1) * (k - x2).
Proof. intros L [H|H]; nra. Qed.

(** L12, exact: at the height of a corner, the point at offset y is not inside iff
    y.(y - d o) >= 0. *)
Theorem R_alignment_iff u o d x1 x2 y : norm2 u = 1 -> dot u o = 0 -> dot u y = 0 ->
  (0 <= R_power u o d x1 x2 (vadd (vscale x1 u) y) <-> 0 <= dot y (vsub y (vscale d o))).
Proof. intros U O Y. rewrite R_power_eq by assumption. split; intros; lra. Qed.

(** Every point beside the rectangle's interval whose offset passes L12 is outside; row
    points of the edge (y = 0) and aligned points of all protectors are of this kind. *)
Theorem R_vs_aligned u o d x1 x2 k y : norm2 u = 1 -> dot u o = 0 -> dot u y = 0 ->
  x1 <= x2 -> not_between x1 x2 k -> 0 <= dot y (vsub y (vscale d o)) ->
  0 <= R_power u o d x1 x2 (vadd (vscale k u) y).
Proof.
  intros U O Y L N A. rewrite R_power_eq by assumption.
  pose proof (not_between_pos x1 x2 k L N). lra.
Qed.

(** Offsets at distance >= d pass L12, strictly unless y = d o. *)
Theorem offset_passes o o' d p : norm2 o = 1 -> norm2 o' = 1 -> 0 < d -> d <= p ->
  0 <= dot (vscale p o') (vsub (vscale p o') (vscale d o)) /\
  (dot o o' < 1 -> 0 < dot (vscale p o') (vsub (vscale p o') (vscale d o))).
Proof.
  intros O O' Hd Hp. pose proof (cauchy_schwarz2 o o') as CS. rewrite O, O' in CS.
  assert (D : dot o o' <= 1) by nra. unfold norm2 in *.
  rewrite dot_sub_r, !dot_scale_l, !dot_scale_r, O', (dot_comm o' o).
  replace (p * (p * 1) - p * (d * dot o o')) with (p * (p - d + d * (1 - dot o o'))) by ring.
  split; intros; [apply Rmult_le_pos|apply Rmult_lt_0_compat]; nra.
Qed.

(** L13 against the other faces at e, at ANY place along it: from the dihedral gap
    d_f >= 3h/2 >= w. *)
Theorem R_vs_other_face u o o' d x1 x2 k p a h : norm2 u = 1 -> norm2 o = 1 -> norm2 o' = 1 ->
  dot u o = 0 -> dot u o' = 0 -> dot o o' <= cos a -> 0 < d -> d <= p -> 0 < h ->
  0 <= a <= PI -> 3 / 2 * h <= 2 * d * sin (a / 2) -> 0 <= x2 - x1 <= 3 / 2 * h ->
  0 < R_power u o d x1 x2 (vadd (vscale k u) (vscale p o')).
Proof.
  intros U O O' UO UO' A Hd Hp Hh Ha G W.
  rewrite R_power_eq; try assumption; [|rewrite dot_scale_r, UO'; ring].
  unfold norm2 in O'. rewrite dot_sub_r, !dot_scale_l, !dot_scale_r, O', (dot_comm o' o).
  rewrite cos_half_angle in A. set (s := sin (a / 2)) in *.
  assert (G2 : 9 / 4 * (h * h) <= 4 * (d * d) * (s * s)).
  { replace (9 / 4 * (h * h)) with ((3 / 2 * h) * (3 / 2 * h)) by field.
    replace (4 * (d * d) * (s * s)) with ((2 * d * s) * (2 * d * s)) by ring. apply sq_le_mono; lra. }
  assert (Q : - (9 / 16 * (h * h)) <= (k - x1) * (k - x2)).
  { pose proof (Rle_0_sqr (k - (x1 + x2) / 2)) as S. unfold Rsqr in S.
    assert ((x2 - x1) * (x2 - x1) <= (3 / 2 * h) * (3 / 2 * h)) by (apply sq_le_mono; lra). nra. }
  assert (M : d * d * (2 * s * s) <= p * (p * 1) - p * (d * dot o o')).
  { replace (p * (p * 1) - p * (d * dot o o')) with (p * (p - d) + p * d * (1 - dot o o')) by ring.
    assert (0 <= p * (p - d)) by nra. assert (d * d <= p * d) by nra.
    assert (0 <= 2 * s * s) by nra.
    assert (d * d * (2 * s * s) <= p * d * (2 * s * s)) by (apply Rmult_le_compat_r; lra).
    assert (p * d * (2 * s * s) <= p * d * (1 - dot o o')) by (apply Rmult_le_compat_l; [nra|lra]). lra. }
  assert (0 < h * h) by nra. lra.
Qed.

(** L13 against Chew points of the own face: the box bulges by less than the
    clearance. p is the point's distance from the edge. *)
Theorem R_vs_own_face u o d x1 x2 k p h : norm2 u = 1 -> norm2 o = 1 -> dot u o = 0 ->
  0 < h -> 1978 / 1000 * h <= d -> 0 <= x2 - x1 <= 3 / 2 * h -> d + h / 2 <= p ->
  0 < R_power u o d x1 x2 (vadd (vscale k u) (vscale p o)).
Proof.
  intros U O UO Hh Hd W Hp. rewrite R_power_eq; try assumption; [|rewrite dot_scale_r, UO; ring].
  unfold norm2 in O. rewrite dot_sub_r, !dot_scale_l, !dot_scale_r, O.
  assert (Q : - (9 / 16 * (h * h)) <= (k - x1) * (k - x2)).
  { pose proof (Rle_0_sqr (k - (x1 + x2) / 2)) as S. unfold Rsqr in S.
    assert ((x2 - x1) * (x2 - x1) <= (3 / 2 * h) * (3 / 2 * h)) by (apply sq_le_mono; lra). nra. }
  assert (2 * h * (h / 2) <= p * (p - d)) by (apply Rmult_le_compat; lra). nra.
Qed.

(** L13 against anything at distance >= 2d from the edge's line. *)
Theorem R_vs_far u o d x1 x2 k y h : norm2 u = 1 -> norm2 o = 1 -> dot u o = 0 -> dot u y = 0 ->
  0 < h -> h <= d -> 0 <= x2 - x1 <= 3 / 2 * h -> (2 * d) * (2 * d) <= norm2 y ->
  0 < R_power u o d x1 x2 (vadd (vscale k u) y).
Proof.
  intros U O UO Y Hh Hd W F. rewrite R_power_eq by assumption. rewrite dot_sub_r, dot_scale_r.
  assert (Q : - (9 / 16 * (h * h)) <= (k - x1) * (k - x2)).
  { pose proof (Rle_0_sqr (k - (x1 + x2) / 2)) as S. unfold Rsqr in S.
    assert ((x2 - x1) * (x2 - x1) <= (3 / 2 * h) * (3 / 2 * h)) by (apply sq_le_mono; lra). nra. }
  pose proof (cauchy_schwarz y o) as CS. pose proof (norm_sqr y) as NY. pose proof (norm_nonneg y) as N0.
  assert (NO : norm o = 1) by (unfold norm; rewrite O; apply sqrt_1). rewrite NO in CS.
  assert (2 * d <= norm y) by (apply sq_le; lra).
  change (dot y y) with (norm2 y). rewrite <- NY.
  assert (d * dot y o <= d * norm y) by (apply Rmult_le_compat_l; lra).
  assert (2 * d * d <= norm y * (norm y - d)) by (apply Rmult_le_compat; lra). nra.
Qed.

(** L13 against points of other edges and faces at an end of e (the origin): they lie
    at distance k >= r cos beta in directions w at angle >= phi* from e. *)
Theorem R_vs_directions u o d x1 x2 w k m phi h : norm2 u = 1 -> norm2 o = 1 -> norm2 w = 1 -> dot u o = 0 ->
  0 < h -> h <= d -> 0 <= x2 - x1 <= 3 / 2 * h -> 0 < phi <= PI / 4 ->
  m <= x1 -> m <= k -> d <= m -> 2 * d <= m * sin phi -> dot u w <= cos phi ->
  0 < R_power u o d x1 x2 (vscale k w).
Proof.
  intros U O W UO Hh Hd Wd Hp M1 Mk Dm Ms A. pose proof PI_RGT_0.
  set (c := dot u w) in *. set (y := vsub (vscale k w) (vscale (k * c) u)).
  replace (vscale k w) with (vadd (vscale (k * c) u) y) by (unfold y; destruct u, w; apply vec_eq; simpl; ring).
  assert (Y0 : dot u y = 0).
  { unfold y, norm2 in *. rewrite dot_sub_r, !dot_scale_r, U. fold c. ring. }
  assert (NY : norm2 y = k * k * (1 - c * c)).
  { unfold y, norm2 in *. rewrite !dot_sub_l, !dot_sub_r, !dot_scale_l, !dot_scale_r, (dot_comm w u), U, W. fold c. ring. }
  destruct (Rle_lt_dec c 0) as [N|P].
  - (* behind the end: k c <= 0 <= x1 *)
    rewrite R_power_eq by assumption. rewrite dot_sub_r, dot_scale_r.
    assert (Q : m * m <= (k * c - x1) * (k * c - x2)).
    { assert (0 <= k * - c) by (apply Rmult_le_pos; lra).
      replace ((k * c - x1) * (k * c - x2)) with ((k * - c + x1) * (k * - c + x2)) by ring.
      apply Rmult_le_compat; lra. }
    pose proof (cauchy_schwarz2 y o) as CS. rewrite O in CS. change (dot y y) with (norm2 y).
    pose proof (norm2_nonneg y). set (t := dot y o) in *. set (n := norm2 y) in *.
    pose proof (Rle_0_sqr (t - d / 2)) as S. unfold Rsqr in S. nra.
  - apply R_vs_far with (h := h); try assumption. rewrite NY.
    assert (S0 : 0 < sin phi) by (apply sin_gt_0; lra).
    pose proof (sin2_cos2 phi) as E. unfold Rsqr in E.
    assert (c * c <= cos phi * cos phi) by (apply sq_le_mono; lra).
    assert (sin phi * sin phi <= 1 - c * c) by lra.
    assert ((2 * d) * (2 * d) <= (m * sin phi) * (m * sin phi)) by (apply sq_le_mono; lra).
    assert (m * m <= k * k) by (apply sq_le_mono; lra).
    assert (0 <= sin phi * sin phi) by nra.
    assert (m * m * (sin phi * sin phi) <= k * k * (1 - c * c)).
    { apply Rmult_le_compat; nra. }
    nra.
Qed.
