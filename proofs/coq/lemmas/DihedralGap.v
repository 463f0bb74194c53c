(** L14, dihedral gap (paper section 3.2: "Let d_f be the length of the base of an
    isosceles triangle with angle alpha and side lengths d_e. Note h' is less than or
    equal to the distance between any incident faces sharing an edge at a point
    outside the buffer-zone.").

    Vector form: u, o, o' unit, o and o' orthogonal to the common edge's direction
    u; o and o' point into the two faces. *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space.
Open Scope R_scope.

Lemma cos_half_angle a : cos a = 1 - 2 * sin (a / 2) * sin (a / 2).
Proof. replace a with (2 * (a / 2)) at 1 by field. apply cos_2a_sin. Qed.

(** Squared distance of x u + p o and y u + q o' when o.o' = k. *)
Lemma face_points_dist2 u o o' x y p q : norm2 u = 1 -> norm2 o = 1 -> norm2 o' = 1 ->
  dot u o = 0 -> dot u o' = 0 ->
  dist2 (vadd (vscale x u) (vscale p o)) (vadd (vscale y u) (vscale q o'))
  = (x - y) * (x - y) + (p - q) * (p - q) + 2 * (p * q) * (1 - dot o o').
Proof.
  unfold norm2. intros U O O' UO UO'. unfold dist2, norm2.
  rewrite !dot_sub_l, !dot_sub_r, !dot_add_l, !dot_add_r, !dot_scale_l, !dot_scale_r.
  rewrite (dot_comm o u), (dot_comm o' u), (dot_comm o' o), U, O, O', UO, UO'. ring.
Qed.

(** Points at distances p and q from the common edge, on faces with dihedral angle at
    least a, are at least 2 sqrt(pq) sin(a/2) apart. Sharper than the paper's lemma
    (p, q >= d), and what lets a centre BEHIND the protector be treated. *)
Theorem dihedral_gap_general u o o' x y p q a : norm2 u = 1 -> norm2 o = 1 -> norm2 o' = 1 ->
  dot u o = 0 -> dot u o' = 0 -> dot o o' <= cos a -> 0 <= p -> 0 <= q ->
  4 * (p * q) * (sin (a / 2) * sin (a / 2)) <=
  dist2 (vadd (vscale x u) (vscale p o)) (vadd (vscale y u) (vscale q o')).
Proof.
  intros U O O' UO UO' A P Q. rewrite face_points_dist2 by assumption.
  rewrite cos_half_angle in A. assert (0 <= p * q) by (apply Rmult_le_pos; assumption).
  pose proof (Rle_0_sqr (x - y)) as Q1. pose proof (Rle_0_sqr (p - q)) as Q2. unfold Rsqr in *.
  assert (2 * (p * q) * (2 * sin (a / 2) * sin (a / 2)) <= 2 * (p * q) * (1 - dot o o'))
    by (apply Rmult_le_compat_l; lra).
  lra.
Qed.

(** L14: distance at least d_f = 2 d sin(alpha/2). *)
Theorem dihedral_gap u o o' x y p q d a : norm2 u = 1 -> norm2 o = 1 -> norm2 o' = 1 ->
  dot u o = 0 -> dot u o' = 0 -> dot o o' <= cos a -> 0 <= a <= PI ->
  0 <= d -> d <= p -> d <= q ->
  2 * d * sin (a / 2) <=
  dist (vadd (vscale x u) (vscale p o)) (vadd (vscale y u) (vscale q o')).
Proof.
  intros U O O' UO UO' A Ha Hd P Q.
  assert (S : 0 <= sin (a / 2)) by (apply sin_ge_0; pose proof PI_RGT_0; lra).
  apply sq_le; [apply dist_nonneg|]. rewrite dist_sqr.
  eapply Rle_trans; [|apply dihedral_gap_general with (a := a); try assumption; lra].
  assert (d * d <= p * q) by nra. set (t := sin (a / 2)) in *. assert (0 <= t * t) by nra.
  replace (2 * d * t * (2 * d * t)) with (4 * (d * d) * (t * t)) by ring. nra.
Qed.

(** The gap is attained by the offsets themselves: d_f is exact. *)
Theorem dihedral_gap_attained u o o' d a : norm2 u = 1 -> norm2 o = 1 -> norm2 o' = 1 ->
  dot u o = 0 -> dot u o' = 0 -> dot o o' = cos a ->
  dist2 (vadd (vscale 0 u) (vscale d o)) (vadd (vscale 0 u) (vscale d o'))
  = (2 * d * sin (a / 2)) * (2 * d * sin (a / 2)).
Proof.
  intros U O O' UO UO' A. rewrite face_points_dist2 by assumption. rewrite A, cos_half_angle. ring.
Qed.

(** The row of theory.md section 6, 9 h^2 <= 4 |o - o'|^2, says h <= (2/3) d_f. *)
Theorem dihedral_gap_rational o o' h : 0 <= h ->
  (9 * (h * h) <= 4 * dist2 o o' <-> h <= 2 / 3 * dist o o').
Proof.
  intros Hh. pose proof (dist_sqr o o') as E. pose proof (dist_nonneg o o').
  rewrite <- E. split; intros; [apply sq_le; nra|nra].
Qed.
