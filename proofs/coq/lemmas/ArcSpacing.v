(** L1, arc spacing (paper section 2.2: "the distances between consecutive Steiner
    points on the circle are in the interval [h, sqrt(3) h]").

    An arc of angle theta on a circle of radius r is cut into
    k = floor(2 theta / phi) equal subarcs. *)
From Coq Require Import Reals Lra Lia Psatz ZArith.
From Confidel.lemmas Require Import Space.
Open Scope R_scope.

(** Length of the chord that subtends the angle t on a circle of radius r. *)
Definition chord r t := 2 * r * sin (t / 2).
Definition subarcs theta phi := Int_part (2 * theta / phi).

Lemma floor_bounds x : IZR (Int_part x) <= x < IZR (Int_part x) + 1.
Proof. destruct (base_Int_part x). lra. Qed.

Lemma floor_ge_2 x : 2 <= x -> (2 <= Int_part x)%Z.
Proof.
  intros Hx. destruct (floor_bounds x) as [_ H].
  assert (IZR 1 < IZR (Int_part x)) as L by lra. apply lt_IZR in L. lia.
Qed.

(** Section 2.2, the displayed computation: theta >= phi gives k >= 2 and
    phi/2 <= theta/k < 3 phi/4. *)
Theorem arc_subdivision phi theta : 0 < phi -> phi <= theta ->
  let k := subarcs theta phi in
  (2 <= k)%Z /\ phi / 2 <= theta / IZR k < 3 * phi / 4.
Proof.
  intros H0 H1 k.
  assert (E : 2 * theta / phi * phi = 2 * theta) by (field; lra).
  assert (Hx : 2 <= 2 * theta / phi) by nra.
  assert (Hk : (2 <= k)%Z) by (apply floor_ge_2; exact Hx).
  destruct (floor_bounds (2 * theta / phi)) as [Ha Hb]. fold (subarcs theta phi) in Ha, Hb. fold k in Ha, Hb.
  assert (HK : 2 <= IZR k) by (apply IZR_le; exact Hk).
  assert (Ha' : IZR k * phi <= 2 * theta) by nra.
  assert (Hb' : 2 * theta < (IZR k + 1) * phi) by nra.
  split; [exact Hk|].
  assert (E2 : theta / IZR k * IZR k = theta) by (field; lra).
  set (q := theta / IZR k) in *. split; nra.
Qed.

Lemma sin_triple y : sin (3 * y) = sin y * (4 * (cos y * cos y) - 1).
Proof.
  replace (3 * y) with (2 * y + y) by ring. rewrite sin_plus, sin_2a, cos_2a_cos. ring.
Qed.

(** sin 3y < (3/2) sin 2y: a chord grows more slowly than its angle. *)
Lemma sin_triple_lt y : 0 < y < PI / 2 -> sin (3 * y) < 3 / 2 * sin (2 * y).
Proof.
  intros [H0 H1].
  assert (0 < sin y) by (apply sin_gt_0; lra).
  assert (0 < cos y) by (apply cos_gt_0; lra).
  assert (C1 : cos y < 1).
  { pose proof (sin2_cos2 y) as E. unfold Rsqr in E. nra. }
  rewrite sin_triple, sin_2a.
  assert (4 * (cos y * cos y) - 1 < 3 * cos y) by nra. nra.
Qed.

(** L1 for any subarc whose angle lies in [phi/2, 3 phi/4]: chord in [h, 3h/2),
    where h is EXACTLY the chord of phi/2. *)
Theorem chord_range r phi t : 0 < r -> 0 < phi <= PI / 4 -> phi / 2 <= t <= 3 * phi / 4 ->
  let h := chord r (phi / 2) in
  h <= chord r t < 3 / 2 * h.
Proof.
  intros Hr Hphi Ht h. unfold h, chord. pose proof PI_RGT_0.
  assert (S1 : sin (phi / 2 / 2) <= sin (t / 2)) by (apply sin_incr_1; lra).
  assert (S2 : sin (t / 2) <= sin (3 * (phi / 8))) by (apply sin_incr_1; lra).
  assert (S3 : sin (3 * (phi / 8)) < 3 / 2 * sin (2 * (phi / 8))) by (apply sin_triple_lt; lra).
  replace (2 * (phi / 8)) with (phi / 2 / 2) in S3 by field.
  split; nra.
Qed.

(** L1 as in the paper: [h, sqrt 3 h]. *)
Theorem chord_range_sqrt3 r phi t : 0 < r -> 0 < phi <= PI / 4 -> phi / 2 <= t <= 3 * phi / 4 ->
  let h := chord r (phi / 2) in
  h <= chord r t <= sqrt 3 * h.
Proof.
  intros Hr Hphi Ht h. destruct (chord_range r phi t Hr Hphi Ht) as [A B]. fold h in A, B.
  split; [exact A|]. pose proof sqrt3_bounds.
  assert (0 < h).
  { unfold h, chord. pose proof PI_RGT_0. assert (0 < sin (phi / 2 / 2)) by (apply sin_gt_0; lra). nra. }
  nra.
Qed.

(** Section 2.2, "it is easy to verify that h <= r/2". *)
Theorem chord_le_half_radius r phi : 0 < r -> 0 < phi <= PI / 4 -> chord r (phi / 2) <= r / 2.
Proof.
  intros Hr [H0 H1]. unfold chord. pose proof PI_4.
  assert (sin (phi / 2 / 2) < phi / 2 / 2) by (apply sin_lt_x; lra). nra.
Qed.

(** L1 for the whole arc, subdivided by the paper's rule. *)
Theorem arc_spacing r phi theta : 0 < r -> 0 < phi <= PI / 4 -> phi <= theta ->
  let h := chord r (phi / 2) in
  let k := subarcs theta phi in
  (2 <= k)%Z /\ h <= chord r (theta / IZR k) < 3 / 2 * h.
Proof.
  intros Hr Hphi Ht h k. destruct (arc_subdivision phi theta) as [K Q]; [lra|lra|].
  fold k in K, Q. split; [exact K|]. apply chord_range; lra.
Qed.

(** L1 for the repaired rule (theory.md section 3): for ANY h <= 2 r sin(phi*/12)
    take phi2 = 4 asin(h / 2r); then phi2 <= phi*/3, which is at most any remaining
    arc, and the chords lie in [h, 3h/2). *)
Theorem arc_spacing_repaired r phi h theta : 0 < r -> 0 < phi <= PI / 4 ->
  0 < h <= 2 * r * sin (phi / 12) -> phi / 3 <= theta ->
  let phi2 := 4 * asin (h / (2 * r)) in
  let k := subarcs theta phi2 in
  0 < phi2 <= phi / 3 /\ (2 <= k)%Z /\ h <= chord r (theta / IZR k) < 3 / 2 * h.
Proof.
  intros Hr Hphi [Hh Hh2] Hth phi2 k. pose proof PI_RGT_0.
  pose proof (SIN_bound (phi / 12)) as SB.
  assert (E : h / (2 * r) * (2 * r) = h) by (field; lra).
  set (x := h / (2 * r)) in *.
  assert (X0 : 0 < x) by nra. assert (X1 : x <= sin (phi / 12)) by nra.
  pose proof (asin_bound x) as AB.
  assert (AX : sin (asin x) = x) by (apply sin_asin; lra).
  assert (A0 : 0 < asin x).
  { destruct (Rlt_le_dec 0 (asin x)) as [L|L]; [exact L|].
    assert (sin (asin x) <= sin 0) by (apply sin_incr_1; lra). rewrite sin_0 in *. lra. }
  assert (A1 : asin x <= phi / 12).
  { destruct (Rle_lt_dec (asin x) (phi / 12)) as [L|L]; [exact L|].
    assert (sin (phi / 12) < sin (asin x)) by (apply sin_increasing_1; lra). lra. }
  assert (P : 0 < phi2 <= phi / 3) by (unfold phi2; lra).
  split; [exact P|].
  destruct (arc_spacing r phi2 theta) as [K C]; try lra.
  fold k in K, C. split; [exact K|].
  replace h with (chord r (phi2 / 2)); [exact C|].
  unfold chord, phi2. replace (4 * asin x / 2 / 2) with (asin x) by field. rewrite AX. lra.
Qed.

(** Section 2.2 says "h be any quantity that is no greater than the chord": with the
    same k the upper bound is then false (theory.md section 1, row 1). *)
Theorem chord_range_needs_exact_h r phi theta : 0 < r -> 0 < phi <= PI / 4 -> phi <= theta ->
  let k := subarcs theta phi in
  exists h, 0 < h <= chord r (phi / 2) /\ sqrt 3 * h < chord r (theta / IZR k).
Proof.
  intros Hr Hphi Ht k. destruct (arc_spacing r phi theta Hr Hphi Ht) as [_ [C _]]. fold k in C.
  pose proof sqrt3_bounds. pose proof PI_RGT_0.
  assert (0 < chord r (phi / 2)).
  { unfold chord. assert (0 < sin (phi / 2 / 2)) by (apply sin_gt_0; lra). nra. }
  exists (chord r (phi / 2) / 2). split; nra.
Qed.
