(** L8, Chew clearance (paper section 2.2: "Chew's algorithm does not place any
    vertices within distance h/2 of the boundary of the protecting polygons"). *)
From Coq Require Import Reals Lra Psatz.
From Confidel.lemmas Require Import Space.
Open Scope R_scope.

(** Stewart's identity: the squared distance to a point of a segment. *)
Lemma stewart P A B t :
  dist2 P (along A B t) = (1 - t) * dist2 P A + t * dist2 P B - t * (1 - t) * dist2 A B.
Proof. vring. Qed.

Lemma mixing_bound t : t * (1 - t) <= 1 / 4.
Proof. pose proof (Rle_0_sqr (t - 1 / 2)) as Q. unfold Rsqr in Q. lra. Qed.

(** A point farther than l from both ends of a segment no longer than L is farther
    than sqrt(l^2 - L^2/4) from every point of it, in R^2 and in R^3. *)
Theorem segment_clearance P A B t l2 L2 : 0 <= t <= 1 ->
  l2 < dist2 P A -> l2 < dist2 P B -> dist2 A B <= L2 ->
  l2 - L2 / 4 < dist2 P (along A B t).
Proof.
  intros Ht HA HB HL. rewrite stewart. pose proof (mixing_bound t) as Q.
  pose proof (dist2_nonneg A B). assert (0 <= t * (1 - t)) by nra.
  assert (t * (1 - t) * dist2 A B <= L2 / 4) by nra.
  destruct (Req_dec t 0) as [->|N]; [nra|].
  assert (l2 < (1 - t) * dist2 P A + t * dist2 P B) by nra. lra.
Qed.

Theorem segment_clearance_closed P A B t l2 L2 : 0 <= t <= 1 ->
  l2 <= dist2 P A -> l2 <= dist2 P B -> dist2 A B <= L2 ->
  l2 - L2 / 4 <= dist2 P (along A B t).
Proof.
  intros Ht HA HB HL. rewrite stewart. pose proof (mixing_bound t) as Q.
  pose proof (dist2_nonneg A B). assert (0 <= t * (1 - t)) by nra.
  assert (t * (1 - t) * dist2 A B <= L2 / 4) by nra. nra.
Qed.

(** L8: ends farther than h, |AB| <= sqrt 3 h: clearance greater than h/2. *)
Theorem chew_clearance P A B t h : 0 < h -> 0 <= t <= 1 ->
  h < dist P A -> h < dist P B -> dist A B <= sqrt 3 * h ->
  h / 2 < dist P (along A B t).
Proof.
  intros Hh Ht HA HB HL. pose proof sqrt3_sqr. pose proof sqrt3_pos.
  pose proof (dist_sqr P A) as EA. pose proof (dist_sqr P B) as EB. pose proof (dist_sqr A B) as EL.
  pose proof (dist_sqr P (along A B t)) as EP. pose proof (dist_nonneg A B) as N.
  apply sq_lt; [apply dist_nonneg|]. rewrite EP.
  assert (X : h * h - 3 * (h * h) / 4 < dist2 P (along A B t)).
  { apply segment_clearance; [exact Ht|nra|nra|].
    rewrite <- EL. apply Rle_trans with ((sqrt 3 * h) * (sqrt 3 * h)); [apply sq_le_mono; lra|].
    right. nra. }
  nra.
Qed.

(** With the real range |AB| <= 3h/2 the clearance is at least 0.661 h. *)
Theorem chew_clearance_own_subdivision P A B t h : 0 < h -> 0 <= t <= 1 ->
  h < dist P A -> h < dist P B -> dist A B <= 3 / 2 * h ->
  661 / 1000 * h < dist P (along A B t).
Proof.
  intros Hh Ht HA HB HL.
  pose proof (dist_sqr P A) as EA. pose proof (dist_sqr P B) as EB. pose proof (dist_sqr A B) as EL.
  pose proof (dist_sqr P (along A B t)) as EP. pose proof (dist_nonneg A B) as N.
  apply sq_lt; [apply dist_nonneg|]. rewrite EP.
  assert (X : h * h - (9 / 4 * (h * h)) / 4 < dist2 P (along A B t)).
  { apply segment_clearance; [exact Ht|nra|nra|nra]. }
  nra.
Qed.
