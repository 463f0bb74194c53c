(** L4, box bulge (paper section 2.3: "the circumcircle of a sqrt(3) h by d_e box can
    only bulge a distance h/2 outside of the buffer-zone; this occurs when d_e = h"). *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space.
Open Scope R_scope.

(** Reach of the circumcircle of a w x d rectangle beyond a side of length w. *)
Definition box_bulge w d := (sqrt (w * w + d * d) - d) / 2.

Lemma box_diagonal w d : let s := sqrt (w * w + d * d) in 0 <= s /\ s * s = w * w + d * d.
Proof. simpl. split; [apply sqrt_pos|apply sqrt_sqrt; nra]. Qed.

(** The number is the reach: a point of the circumcircle of the box
    [0,w] x [0,d] has height at least -(box_bulge w d). *)
Theorem box_bulge_is_reach w d x y :
  (x - w / 2) * (x - w / 2) + (y - d / 2) * (y - d / 2) = (w * w + d * d) / 4 -> - box_bulge w d <= y.
Proof.
  intros C. unfold box_bulge. destruct (box_diagonal w d) as [S0 SS].
  set (s := sqrt (w * w + d * d)) in *. pose proof (Rle_0_sqr (x - w / 2)) as Q. unfold Rsqr in Q. nra.
Qed.

(** Bound and equality case. *)
Theorem box_bulge_le_half w d h : 0 < h -> 0 <= w <= sqrt 3 * h -> h <= d ->
  box_bulge w d <= h / 2 /\ (box_bulge w d = h / 2 <-> w = sqrt 3 * h /\ d = h).
Proof.
  intros Hh [Hw Hws] Hd. unfold box_bulge.
  pose proof sqrt3_sqr. pose proof sqrt3_pos.
  assert (W2 : w * w <= 3 * h * h) by nra.
  destruct (box_diagonal w d) as [S0 SS]. set (s := sqrt (w * w + d * d)) in *.
  split; [nra|]. split.
  - intros E. assert (Es : s = d + h) by lra. rewrite Es in SS.
    assert (Hd2 : d = h) by nra. split; [nra|exact Hd2].
  - intros [Ew Ed]. assert (s = 2 * h) by nra. lra.
Qed.

(** The row of theory.md section 6 without roots. *)
Theorem box_bulge_rational w d h : 0 < h -> 0 <= d ->
  (box_bulge w d <= h / 2 <-> w * w <= h * h \/
     (w * w - h * h) * (w * w - h * h) <= 4 * (h * h) * (d * d)).
Proof.
  intros Hh Hd. unfold box_bulge.
  destruct (box_diagonal w d) as [S0 SS]. set (s := sqrt (w * w + d * d)) in *.
  assert (I : (s - d) / 2 <= h / 2 <-> w * w - h * h <= 2 * h * d).
  { split; intros; nra. }
  rewrite I. split.
  - intros L. destruct (Rle_dec (w * w) (h * h)) as [G|G]; [left; exact G|right].
    replace (4 * (h * h) * (d * d)) with ((2 * h * d) * (2 * h * d)) by ring.
    apply sq_le_mono; lra.
  - intros [L|L]; [nra|]. apply sq_le; [nra|]. lra.
Qed.

(** With the paper's own subdivision (w < 3h/2) the worst case never occurs:
    the bulge stays below 0.4015 h (theory.md section 1 gives 0.4014). *)
Theorem box_bulge_own_subdivision w d h : 0 < h -> 0 <= w <= 3 / 2 * h -> h <= d ->
  box_bulge w d <= 4014 / 10000 * h.
Proof.
  intros Hh [Hw Hws] Hd. unfold box_bulge.
  destruct (box_diagonal w d) as [S0 SS]. set (s := sqrt (w * w + d * d)) in *.
  assert (W : w * w <= 9 / 4 * (h * h)) by nra.
  assert (s <= d + 8028 / 10000 * h) by (apply sq_le; nra). lra.
Qed.
