(** L12 and L23, alignment (paper section 2.3: "we can ensure that e is refined so
    that no Steiner point falls in the interior of these circles"; section 3.2: "this
    follows from the alignment of Steiner points of the protecting edges").

    Coordinates at an edge e: x along e; the sphere is centred in its own face at
    (c, s), s being the distance from e. The own protector is the line at distance d.
    A second face makes the dihedral angle a with the first one; its protector is at
    distance d', a point of it being (x, d' cos a, d' sin a). *)
From Coq Require Import Reals Lra Lia Psatz ZArith.
From Confidel.lemmas Require Import Space.
Open Scope R_scope.

(** ** In the plane *)

(** A circle through two neighbouring points of a protector, with its centre at most
    h/2 behind it, contains no aligned point of the edge (x_0 + i w, 0). *)
Theorem align_2D x0 w t R d h (i : Z) : 0 <= h -> t <= h / 2 -> h <= d ->
  R * R = t * t + w * w / 4 ->
  let x := x0 + IZR i * w in
  R * R <= (x - (x0 + w / 2)) * (x - (x0 + w / 2)) + (d - t) * (d - t).
Proof.
  intros Hh Ht Hd HR x. unfold x.
  assert (I : 1 / 4 <= (IZR i - 1 / 2) * (IZR i - 1 / 2)).
  { destruct (Z_lt_le_dec i 1) as [L|L].
    - assert (IZR i <= 0) by (apply IZR_le; lia). nra.
    - assert (1 <= IZR i) by (apply IZR_le; lia). nra. }
  rewrite HR.
  replace (x0 + IZR i * w - (x0 + w / 2)) with ((IZR i - 1 / 2) * w) by field.
  replace ((IZR i - 1 / 2) * w * ((IZR i - 1 / 2) * w))
    with ((IZR i - 1 / 2) * (IZR i - 1 / 2) * (w * w)) by ring.
  assert (0 <= w * w) by nra. assert (t * t <= (d - t) * (d - t)) by nra. nra.
Qed.

(** No spacing needed: if the protector's point above x is not inside, the edge's
    point is not inside either, as long as the centre is not below mid-depth. *)
Theorem align_2D_any_row c t R2 d x : 0 <= d -> t <= d / 2 ->
  R2 <= (x - c) * (x - c) + t * t -> R2 <= (x - c) * (x - c) + (d - t) * (d - t).
Proof. intros. nra. Qed.

(** L23: where t <= h/2 comes from: R <= h and the third vertex of the triangle,
    which is at least h/2 in front of the protector (L8). *)
Theorem depth_bound h (R t c Cx Cy : R) : 0 <= R <= h ->
  (Cx - c) * (Cx - c) + (Cy + t) * (Cy + t) = R * R -> h / 2 <= Cy -> t <= h / 2.
Proof.
  intros HR HC Hc. pose proof (Rle_0_sqr (Cx - c)) as Q. unfold Rsqr in Q.
  assert (Cy + t <= R) by nra. lra.
Qed.

(** R <= h and spacing >= h alone do not give it. *)
Theorem depth_bound_needs_third_vertex : exists h w t R,
  0 < h /\ h <= w <= sqrt 3 * h /\ 0 <= R <= h /\ R * R = t * t + w * w / 4 /\ ~ t <= h / 2.
Proof.
  exists 1, 1, (sqrt 3 / 2), 1. pose proof sqrt3_sqr. pose proof sqrt3_bounds.
  repeat split; nra.
Qed.

(** L23: a circle of radius R <= h whose centre is at most h/2 behind a boundary
    segment penetrates the buffer by at most 3h/2. *)
Theorem buffer_penetration h t R x c y : t <= h / 2 -> 0 <= R <= h ->
  (x - c) * (x - c) + (y + t) * (y + t) <= R * R -> - (3 / 2 * h) <= y.
Proof.
  intros Ht HR HC. pose proof (Rle_0_sqr (x - c)) as Q. unfold Rsqr in Q.
  assert ((y + t) * (y + t) <= R * R) by lra. assert (- R <= y + t) by nra. lra.
Qed.

(** ** In space: the true condition for unequal offsets *)

Definition aligned_ok s d d' a := 0 <= d' * d' - d * d + 2 * s * (d - d' * cos a).

Lemma sin_sqr_prod k a : k * sin a * (k * sin a) = k * k * (1 - cos a * cos a).
Proof. pose proof (sin2_cos2 a) as E. unfold Rsqr in E. rewrite <- E. ring. Qed.

(** Exact: the other face's aligned point is at least as far from the centre as the
    own protector's point iff [aligned_ok]. *)
Theorem align_3D_iff c s d d' a x :
  (x - c) * (x - c) + (d - s) * (d - s) <=
  (x - c) * (x - c) + (d' * cos a - s) * (d' * cos a - s) + (d' * sin a) * (d' * sin a)
  <-> aligned_ok s d d' a.
Proof. unfold aligned_ok. pose proof (sin_sqr_prod d' a). split; intros; nra. Qed.

(** The condition is affine in s: its two ends decide a range of centres. *)
Theorem aligned_ok_affine s0 s1 d d' a : s0 <= s1 ->
  (forall s, s0 <= s <= s1 -> aligned_ok s d d' a) <->
  (aligned_ok s0 d d' a /\ aligned_ok s1 d d' a).
Proof.
  unfold aligned_ok. intros L. split.
  - intros K. split; apply K; lra.
  - intros [K0 K1] s [? ?]. set (q := d - d' * cos a) in *. destruct (Rle_dec 0 q); nra.
Qed.

(** Lowest centre s = d/2 (the rectangles R themselves): d cos a <= d'. In the vector
    form of L12 this is o'.(o' - o) >= 0. *)
Theorem aligned_ok_rectangle d d' a : 0 < d' -> (aligned_ok (d / 2) d d' a <-> d * cos a <= d').
Proof.
  unfold aligned_ok. intros Hd'.
  replace (d' * d' - d * d + 2 * (d / 2) * (d - d' * cos a)) with (d' * (d' - d * cos a)) by field.
  split; intros; nra.
Qed.

Theorem aligned_ok_vector o o' s : 0 < norm2 o ->
  (* the centre is s o / |o|, the aligned points are o and o' *)
  (dist2 (vscale s o) o <= dist2 (vscale s o) o' <->
   0 <= dot o' o' - dot o o + 2 * s * (dot o o - dot o o')).
Proof.
  intros H. unfold dist2, norm2 in *. rewrite !dot_sub_l, !dot_sub_r, !dot_scale_l, !dot_scale_r.
  rewrite (dot_comm o' o). split; intros; lra.
Qed.

(** Equal offsets: true for every dihedral angle and every centre in the face. *)
Theorem aligned_ok_equal_offsets s d a : 0 <= s -> 0 <= d -> aligned_ok s d d a.
Proof.
  intros Hs Hd. unfold aligned_ok. pose proof (COS_bound a).
  replace (d * d - d * d + 2 * s * (d - d * cos a)) with (2 * (s * (d * (1 - cos a)))) by ring.
  assert (0 <= d * (1 - cos a)) by nra. nra.
Qed.

(** Unequal offsets, all dihedral angles at once: the centre must be on the right
    side of the middle (d + d')/2. *)
Theorem aligned_ok_larger s d d' : 0 <= s -> 0 < d -> d < d' ->
  ((forall a, aligned_ok s d d' a) <-> s <= (d + d') / 2).
Proof.
  intros Hs Hd Hd'. split.
  - intros K. specialize (K 0). unfold aligned_ok in K. rewrite cos_0 in K. nra.
  - intros L a. unfold aligned_ok. pose proof (COS_bound a).
    assert (0 <= (d' - d) * (d' + d - 2 * s)) by (apply Rmult_le_pos; lra).
    assert (0 <= s * d' * (1 - cos a)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). nra.
Qed.

Theorem aligned_ok_smaller s d d' : 0 <= s -> 0 < d' -> d' < d ->
  ((forall a, aligned_ok s d d' a) <-> (d + d') / 2 <= s).
Proof.
  intros Hs Hd Hd'. split.
  - intros K. specialize (K 0). unfold aligned_ok in K. rewrite cos_0 in K. nra.
  - intros L a. unfold aligned_ok. pose proof (COS_bound a).
    assert (0 <= (d - d') * (2 * s - d - d')) by (apply Rmult_le_pos; lra).
    assert (0 <= s * d' * (1 - cos a)) by (apply Rmult_le_pos; [apply Rmult_le_pos|]; lra). nra.
Qed.

(** The alignment lemma in space: with the own protector's points outside, the
    aligned points of e and of the other face are outside. *)
Theorem align_3D c s R2 d d' a x : 0 <= d -> d / 2 <= s -> aligned_ok s d d' a ->
  R2 <= (x - c) * (x - c) + (d - s) * (d - s) ->
  R2 <= (x - c) * (x - c) + s * s /\
  R2 <= (x - c) * (x - c) + (d' * cos a - s) * (d' * cos a - s) + (d' * sin a) * (d' * sin a).
Proof.
  intros Hd Hs K H. split; [nra|].
  apply Rle_trans with (1 := H). apply align_3D_iff. exact K.
Qed.

(** With all the paper's bounds a smaller offset on the other face fails: h = 1,
    d = 2, d' = 9/5, depth 1/2, w = sqrt 3, R = 1, and the two faces coplanar in the
    limit a = 0. *)
Theorem align_3D_fails_for_smaller_offset : exists h d d' t w R a,
  0 < h /\ h <= d /\ h <= d' /\ t <= h / 2 /\ h <= w /\ w * w <= 3 * h * h /\
  R * R = t * t + w * w / 4 /\ R <= h /\ ~ aligned_ok (d - t) d d' a.
Proof.
  exists 1, 2, (9/5), (1/2), (sqrt 3), 1, 0. pose proof sqrt3_sqr. pose proof sqrt3_bounds.
  unfold aligned_ok. rewrite cos_0. repeat split; nra.
Qed.

(** All centres together, unequal offsets: up to s = d the alignment argument
    works, beyond it the dihedral gap 2 m sin(a/2) >= h does. *)
Theorem align_3D_all_centres c s R h d d' m a x : 0 < m -> m <= d -> m <= d' -> 0 <= a <= PI ->
  d * cos a <= d' -> d / 2 <= s -> 0 <= R <= h -> h <= 2 * m * sin (a / 2) ->
  R * R <= (x - c) * (x - c) + (d - s) * (d - s) ->
  R * R <= (x - c) * (x - c) + (d' * cos a - s) * (d' * cos a - s) + (d' * sin a) * (d' * sin a).
Proof.
  intros Hm Hd Hd' Ha HT Hs HR Hh H.
  destruct (Rle_dec s d) as [L|L].
  - apply Rle_trans with (1 := H). apply align_3D_iff.
    assert (K : forall s, d / 2 <= s <= d -> aligned_ok s d d' a); [|apply K; lra].
    apply aligned_ok_affine; [lra|]. split; [apply aligned_ok_rectangle; lra|].
    unfold aligned_ok. pose proof (COS_bound a).
    replace (d' * d' - d * d + 2 * d * (d - d' * cos a))
      with ((d - d') * (d - d') + 2 * (d * d') * (1 - cos a)) by ring.
    assert (0 <= d * d') by (apply Rmult_le_pos; lra).
    assert (0 <= d * d' * (1 - cos a)) by (apply Rmult_le_pos; lra).
    pose proof (Rle_0_sqr (d - d')) as Q. unfold Rsqr in Q. lra.
  - assert (S : 0 <= sin (a / 2)) by (apply sin_ge_0; pose proof PI_RGT_0; lra).
    assert (C : cos a = 1 - 2 * sin (a / 2) * sin (a / 2)).
    { replace a with (2 * (a / 2)) at 1 by field. apply cos_2a_sin. }
    rewrite (sin_sqr_prod d' a). set (u := sin (a / 2)) in *.
    replace ((x - c) * (x - c) + (d' * cos a - s) * (d' * cos a - s) + d' * d' * (1 - cos a * cos a))
      with ((x - c) * (x - c) + (d' - s) * (d' - s) + 2 * (d' * s) * (1 - cos a)) by ring.
    rewrite C. assert (M : m * m <= d' * s) by (apply Rmult_le_compat; lra).
    assert (U : 0 <= u * u) by (apply Rmult_le_pos; lra).
    assert (M2 : m * m * (u * u) <= d' * s * (u * u)) by (apply Rmult_le_compat_r; lra).
    assert (R * R <= (2 * m * u) * (2 * m * u)) by (apply Rmult_le_compat; lra).
    pose proof (Rle_0_sqr (x - c)) as Q1. pose proof (Rle_0_sqr (d' - s)) as Q2.
    unfold Rsqr in *. lra.
Qed.
