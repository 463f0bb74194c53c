(** L2, edge and protector spacing (paper sections 2.2 and 2.3: "each such edge of
    length l is subdivided into j = floor(l/h) subsegments of equal lengths ...
    it is important to obtain a sequence of identical intervals"). *)
From Coq Require Import Reals Lra Lia Psatz ZArith.
From Confidel.lemmas Require Import Space ArcSpacing.
Open Scope R_scope.

Definition intervals l h := Int_part (l / h).

Theorem edge_spacing l h : 0 < h -> 2 * h <= l ->
  let j := intervals l h in
  (2 <= j)%Z /\ h <= l / IZR j < 3 / 2 * h.
Proof.
  intros Hh Hl j.
  destruct (floor_bounds (l / h)) as [Ha Hb]. fold (intervals l h) in Ha, Hb. fold j in Ha, Hb.
  assert (E : l / h * h = l) by (field; lra). set (q := l / h) in *.
  assert (Q : 2 <= q) by nra.
  assert (Hj : (2 <= j)%Z) by (apply floor_ge_2; exact Q).
  assert (HJ : 2 <= IZR j) by (apply IZR_le; exact Hj).
  split; [exact Hj|].
  assert (E2 : l / IZR j * IZR j = l) by (field; lra). set (p := l / IZR j) in *.
  split; nra.
Qed.

Theorem edge_spacing_sqrt3 l h : 0 < h -> 2 * h <= l ->
  h <= l / IZR (intervals l h) <= sqrt 3 * h.
Proof.
  intros Hh Hl. destruct (edge_spacing l h Hh Hl) as [_ [A B]].
  pose proof sqrt3_bounds. split; nra.
Qed.

(** The part of an edge between its two cap points is at least r long when the
    protecting balls are 3r apart: enough for two intervals as 2h <= r. *)
Theorem edge_has_two_intervals len r m h : 0 < r -> m <= r -> 3 * r <= len -> 2 * h <= r ->
  2 * h <= len - 2 * m.
Proof. intros. lra. Qed.

(** Aligned rows: a protector is the row moved by one offset o, so it inherits the
    row's spacing exactly. *)
Theorem aligned_row_spacing x y o : dist2 (vadd x o) (vadd y o) = dist2 x y.
Proof. vring. Qed.

(** ... and with o orthogonal to the edge the cells are rectangles: both diagonals
    are diameters of one circle. *)
Theorem aligned_cell_is_rectangle x y o : dot (vsub y x) o = 0 ->
  let c := vscale (1 / 2) (vadd x (vadd y o)) in
  dist2 c y = dist2 c x /\ dist2 c (vadd x o) = dist2 c x /\ dist2 c (vadd y o) = dist2 c x.
Proof. intros H c. unfold c. vcoords. repeat split; lra. Qed.
