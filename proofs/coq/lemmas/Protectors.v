(** L5 and L7: protectors of neighbouring edges do not cross, corners of P'' are
    obtuse (paper section 2.3, implicit there); L22: hanging edges (section 1.3). *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space.
Open Scope R_scope.

Definition planar_point r t := Vec (r * cos t) (r * sin t) 0.

(** L5: edges of a face at angles 0 and theta < pi, a+ at angle beta1 from the first, a-
    at beta2 before the second: (a+ x a-).n > 0 iff beta1 + beta2 < theta. *)
Theorem protectors_do_not_cross r theta beta1 beta2 : 0 < r -> 0 < theta < PI -> 0 < beta1 -> 0 < beta2 ->
  beta1 + beta2 <= PI ->
  (0 < vz (cross (planar_point r beta1) (planar_point r (theta - beta2))) <-> beta1 + beta2 < theta).
Proof.
  intros Hr Ht H1 H2 H3. unfold cross, planar_point; simpl.
  replace (r * cos beta1 * (r * sin (theta - beta2)) - r * sin beta1 * (r * cos (theta - beta2)))
    with (r * r * sin (theta - beta2 - beta1)) by (rewrite (sin_minus (theta - beta2)); ring).
  assert (0 < r * r) by nra. split; intros H0.
  - destruct (Rlt_le_dec (beta1 + beta2) theta) as [L|L]; [exact L|].
    assert (sin (theta - beta2 - beta1) <= 0).
    { replace (theta - beta2 - beta1) with (- (beta1 + beta2 - theta)) by ring. rewrite sin_neg.
      assert (0 <= sin (beta1 + beta2 - theta)) by (apply sin_ge_0; lra). lra. }
    nra.
  - assert (0 < sin (theta - beta2 - beta1)) by (apply sin_gt_0; lra). nra.
Qed.

(** With beta = phi/3 and phi at most the angle: at least a third of it remains. *)
Theorem repaired_protectors_do_not_cross r theta phi : 0 < r -> 0 < phi <= theta -> theta < PI ->
  0 < vz (cross (planar_point r (phi / 3)) (planar_point r (theta - phi / 3))).
Proof. intros Hr Hp Ht. apply protectors_do_not_cross; lra. Qed.

(** L7: at the corner a of P'' between a protector (direction u of the edge) and the
    first chord: a at angle beta, p1 at angle t > beta from e; (q1 - a).(p1 - a) <= 0. *)
Theorem corner_obtuse r beta t k : 0 < r -> 0 <= k -> 0 <= beta -> beta < t -> t < PI ->
  let a := planar_point r beta in
  let p1 := planar_point r t in
  let q1 := vadd a (Vec k 0 0) in
  dot (vsub q1 a) (vsub p1 a) <= 0.
Proof.
  intros Hr Hk H0 H1 H2 a p1 q1. unfold q1, a, p1, planar_point, dot, vsub, vadd; simpl.
  assert (cos t < cos beta) by (apply cos_decreasing_1; lra).
  replace ((r * cos beta + k - r * cos beta) * (r * cos t - r * cos beta) +
    (r * sin beta + 0 - r * sin beta) * (r * sin t - r * sin beta) + (0 + 0 - 0) * (0 - 0))
    with (- (k * r * (cos beta - cos t))) by ring.
  assert (0 <= k * r) by nra. assert (0 <= k * r * (cos beta - cos t)) by (apply Rmult_le_pos; lra). lra.
Qed.

(** L7 between two chords of the polygon around v: interior angle of P'' above pi. Its
    supplement inside the buffer is below pi as the polygon is convex: three points
    of the circle turn left. *)
Theorem arc_polygon_convex r t1 t2 t3 : 0 < r -> t1 < t2 -> t2 < t3 -> t3 - t1 < PI ->
  0 < vz (cross (vsub (planar_point r t2) (planar_point r t1)) (vsub (planar_point r t3) (planar_point r t2))).
Proof.
  intros Hr H1 H2 H3. unfold cross, vsub, planar_point; simpl.
  replace ((r * cos t2 - r * cos t1) * (r * sin t3 - r * sin t2) - (r * sin t2 - r * sin t1) * (r * cos t3 - r * cos t2))
    with (r * r * (sin (t3 - t2) + sin (t2 - t1) - sin (t3 - t1))) by (rewrite !sin_minus; ring).
  set (x := (t3 - t2) / 2). set (y := (t2 - t1) / 2).
  replace (t3 - t2) with (2 * x) by (unfold x; field).
  replace (t2 - t1) with (2 * y) by (unfold y; field).
  replace (t3 - t1) with (2 * (x + y)) by (unfold x, y; field).
  rewrite !sin_2a, sin_plus, cos_plus.
  assert (Sx : 0 < sin x) by (apply sin_gt_0; unfold x; lra).
  assert (Sy : 0 < sin y) by (apply sin_gt_0; unfold y; lra).
  assert (Sxy : 0 < sin (x + y)) by (apply sin_gt_0; unfold x, y; lra). rewrite sin_plus in Sxy.
  pose proof (sin2_cos2 x) as Ex. pose proof (sin2_cos2 y) as Ey. unfold Rsqr in *.
  assert (0 < r * r) by nra.
  replace (2 * sin x * cos x + 2 * sin y * cos y - 2 * (sin x * cos y + cos x * sin y) * (cos x * cos y - sin x * sin y))
    with (4 * (sin x * sin y) * (sin x * cos y + cos x * sin y)).
  - apply Rmult_lt_0_compat; [assumption|]. apply Rmult_lt_0_compat; nra.
  - set (sx := sin x) in *. set (cx := cos x) in *. set (sy := sin y) in *. set (cy := cos y) in *.
    assert (Ix : sx * sx = 1 - cx * cx) by lra. assert (Iy : sy * sy = 1 - cy * cy) by lra.
    replace (2 * sx * cx + 2 * sy * cy - 2 * (sx * cy + cx * sy) * (cx * cy - sx * sy))
      with (2 * sx * cx * (1 - cy * cy) + 2 * sy * cy * (1 - cx * cx)
            + 2 * (sx * sx) * (sy * cy) + 2 * (sy * sy) * (sx * cx)) by ring.
    rewrite <- Ix, <- Iy. ring.
Qed.

(** ** L22, hanging subsegments *)

(** (x - a).(x - b) is the power of x for the ball with diameter ab. *)
Theorem hanging_power a b x :
  power (vscale (1 / 2) (vadd a b)) a x = dot (vsub x a) (vsub x b).
Proof. destruct a, b, x. unfold power, dist2, norm2, dot, vsub, vadd, vscale; simpl. field. Qed.

(** Splitting a segment finely enough: points at distance more than half the
    subsegment's length from all of it are strictly outside its diametral ball. *)
Theorem hanging_clear a b x : (forall t, 0 <= t <= 1 -> dist2 a b / 4 < dist2 x (along a b t)) ->
  0 < dot (vsub x a) (vsub x b).
Proof.
  intros H. specialize (H (1 / 2)). rewrite <- hanging_power. unfold power.
  assert (E : dist2 (vscale (1 / 2) (vadd a b)) x = dist2 x (along a b (1 / 2))).
  { destruct a, b, x. unfold along, dist2, norm2, dot, vsub, vadd, vscale; simpl. field. }
  assert (F : dist2 (vscale (1 / 2) (vadd a b)) a = dist2 a b / 4).
  { destruct a, b. unfold dist2, norm2, dot, vsub, vadd, vscale; simpl. field. }
  rewrite E, F. specialize (H ltac:(lra)). lra.
Qed.

(** Neighbouring edges at angle >= phi (paper, section 1.3: a generalisation of
    Saalfeld's algorithm): the end piece [v, m] of a hanging edge against points of
    other edges and faces at v, at distance >= k = |m| in directions at a positive angle. *)
Theorem hanging_end_piece m x : norm2 m <= norm2 x -> x <> m -> dot m x < norm m * norm x ->
  0 < dot (vsub x vzero) (vsub x m).
Proof.
  intros K N A. replace (dot (vsub x vzero) (vsub x m)) with (norm2 x - dot m x) by vring.
  pose proof (norm_sqr m). pose proof (norm_sqr x). pose proof (norm_nonneg m). pose proof (norm_nonneg x).
  assert (norm m <= norm x) by (apply sq_le; lra). nra.
Qed.
