(** Parts of "consecutive implies legal": the construction's boundary points at the same
    corner or edge are beside a spoke or rectangle, points far from the corner are clear. *)
From Coq Require Import Reals Lra Psatz List Classical.
From Confidel.lemmas Require Import Space Margins EdgeCells.
From Confidel.theorem Require Import Complex Placement FaceGeometry InFace.
Open Scope R_scope.

Section Legality.
Variables (v w z : vec) (zx zy : R).
Hypothesis F : frame v w z (dir v w) (offset v w z) zx zy.
Let U := fr_u _ _ _ _ _ _ _ F.
Let O := fr_o _ _ _ _ _ _ _ F.
Let UO := fr_uo _ _ _ _ _ _ _ F.

Lemma dot_bisector m X Y :
  dot (arc_vec 1 v w z m) (vadd (vscale X (dir v w)) (vscale Y (offset v w z))) = X * cos m + Y * sin m.
Proof.
  unfold arc_vec. rewrite dot_add_l, !dot_scale_l.
  destruct (dot_frame _ _ X Y U O UO) as (-> & -> & _). ring.
Qed.

(** S against arc points of the same arc that are not strictly within it. *)
Theorem arc_beside_spoke theta r t1 t2 t : corner_angle v w z theta -> 0 < r ->
  0 <= t1 -> t1 < t2 -> t2 <= theta -> 0 <= t <= theta -> (t <= t1 \/ t2 <= t) ->
  dot (arc_vec 1 v w z ((t1 + t2) / 2)) (arc_vec r v w z t) <= norm (arc_vec r v w z t) * cos ((t2 - t1) / 2).
Proof.
  intros [Tr _] Hr H1 H2 H3 Ht S.
  assert (N : norm (arc_vec r v w z t) = r).
  { rewrite (arc_vec_eq _ _ _ _ _ _ _ F). unfold norm. rewrite (arc_norm2 v w z _ _ zx zy F). apply sqrt_square. lra. }
  rewrite N. unfold arc_vec at 2. rewrite dot_bisector.
  set (m := (t1 + t2) / 2). set (a := (t2 - t1) / 2).
  replace (r * cos t * cos m + r * sin t * sin m) with (r * cos (m - t)) by (rewrite cos_minus; ring).
  apply Rmult_le_compat_l; [lra|]. destruct S as [S|S].
  - apply cos_decr_1; unfold m, a; lra.
  - rewrite <- (cos_neg (m - t)). apply cos_decr_1; unfold m, a; lra.
Qed.

(** S (bisector at angle m, half-angle a) against the protector of the edge vw: its
    points are seen from v at an angle of at most beta from the edge. The protector of
    the corner's other edge is this theorem for the face read as v z w. *)
Theorem protector_beside_spoke r beta k m a : 0 < r -> 0 < beta < PI / 2 -> r * cos beta <= k ->
  0 <= a -> beta + a <= m -> m <= PI ->
  let y := vadd (vscale k (dir v w)) (vscale (r * sin beta) (offset v w z)) in
  dot (arc_vec 1 v w z m) y <= norm y * cos a.
Proof.
  intros Hr Hb Hk Ha Hm Hp y. unfold y. rewrite dot_bisector. fold y.
  assert (Sb : 0 < sin beta) by (apply sin_gt_0; lra). assert (Cb : 0 < cos beta) by (apply cos_gt_0; lra).
  pose proof (sin2_cos2 beta) as E. unfold Rsqr in E.
  set (d := r * sin beta). assert (D0 : 0 < d) by (apply Rmult_lt_0_compat; assumption).
  assert (K0 : 0 < k) by nra.
  assert (NY : norm y * norm y = k * k + d * d).
  { rewrite norm_sqr. unfold y. apply (dot_frame _ _ k d U O UO). }
  pose proof (norm_nonneg y) as N0. set (n := norm y) in *.
  assert (NP : 0 < n) by nra.
  set (c := k / n). assert (EC : c * n = k) by (unfold c; field; lra).
  assert (C1 : c * c + (d / n) * (d / n) = 1).
  { apply Rmult_eq_reg_r with (n * n); [|nra].
    transitivity (k * k + d * d); [unfold c; field; lra|lra]. }
  assert (DN : 0 < d / n) by (apply Rdiv_lt_0_compat; assumption).
  assert (ED : d / n * n = d) by (field; lra). set (s := d / n) in *.
  assert (C0 : 0 < c) by (apply Rdiv_lt_0_compat; assumption).
  assert (Cl : c < 1) by nra.
  pose proof (acos_bound c) as AB. assert (CT : cos (acos c) = c) by (apply cos_acos; lra).
  set (tau := acos c) in *.
  assert (ST : sin tau = s).
  { pose proof (sin2_cos2 tau) as ET. unfold Rsqr in ET. rewrite CT in ET.
    assert (0 <= sin tau) by (apply sin_ge_0; lra).
    assert (sin tau * sin tau = s * s) by lra. nra. }
  (* tau <= beta since cos beta <= c *)
  assert (CB : cos beta <= c).
  { apply Rmult_le_reg_r with n; [exact NP|]. rewrite EC. apply sq_le; [lra|].
    replace (cos beta * n * (cos beta * n)) with (cos beta * cos beta * (k * k + d * d)) by (rewrite <- NY; ring).
    assert (cos beta * cos beta * (d * d) <= sin beta * sin beta * (k * k)).
    { replace (cos beta * cos beta * (d * d)) with (sin beta * sin beta * ((r * cos beta) * (r * cos beta))) by (unfold d; ring).
      apply Rmult_le_compat_l; [nra|]. apply sq_le_mono; [nra|lra]. }
    replace (sin beta * sin beta) with (1 - cos beta * cos beta) in * by lra. lra. }
  assert (TB : tau <= beta).
  { destruct (Rle_lt_dec tau beta) as [L|L]; [exact L|].
    assert (cos tau < cos beta) by (apply cos_decreasing_1; lra). lra. }
  fold d. rewrite <- EC, <- ED.
  replace (c * n * cos m + s * n * sin m) with (n * cos (m - tau)) by (rewrite cos_minus, CT, ST; ring).
  apply Rmult_le_compat_l; [lra|]. apply cos_decr_1; lra.
Qed.

(** Anything at distance 2r from the corner is clear of the chords of its arc. *)
Theorem far_from_corner_clear h r t1 t2 x : 0 < r -> h < 2 * r -> 2 * r <= dist v x ->
  clear_of h (vadd v (arc_vec r v w z t1)) (vadd v (arc_vec r v w z t2)) x.
Proof.
  intros Hr Hh D s Hs.
  assert (N : forall t, norm (arc_vec r v w z t) = r).
  { intros t. rewrite (arc_vec_eq _ _ _ _ _ _ _ F). unfold norm. rewrite (arc_norm2 v w z _ _ zx zy F). apply sqrt_square. lra. }
  set (p := arc_vec r v w z t1). set (q := arc_vec r v w z t2). set (y := along (vadd v p) (vadd v q) s).
  assert (EY : vsub y v = vadd (vscale (1 - s) p) (vscale s q)).
  { unfold y. generalize v p q. intros. apply vec_eq; unfold along, vadd, vsub, vscale; simpl; ring. }
  assert (DY : dist v y <= r).
  { rewrite dist_sym. unfold dist. rewrite EY.
    eapply Rle_trans; [apply norm_triangle|]. rewrite !norm_scale, !Rabs_pos_eq by lra. unfold p, q. rewrite !N. lra. }
  pose proof (dist_triangle v y x) as T. rewrite (dist_sym y x) in T. lra.
Qed.

(** R against the arcs at its end: they do not reach past the cap point. *)
Theorem arc_beside_rectangle r beta t x1 x2 : 0 < r -> 0 <= beta -> beta <= t <= PI -> r * cos beta <= x1 ->
  not_between x1 x2 (dot (dir v w) (arc_vec r v w z t)).
Proof.
  intros Hr Hb Ht H. left. unfold arc_vec.
  destruct (dot_frame _ _ (r * cos t) (r * sin t) U O UO) as (-> & _ & _).
  apply Rle_trans with (r * cos beta); [|exact H]. apply Rmult_le_compat_l; [lra|]. apply cos_decr_1; lra.
Qed.
End Legality.
