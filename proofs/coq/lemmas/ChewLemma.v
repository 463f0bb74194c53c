(** L8, the clean Chew lemma (paper section 2.1: "circumcenters of triangles whose radii
    are larger than h are inserted, one at a time"; theory.md section 3).

    In the Delaunay triangulation of ALL points of a face a triangle t of P'' with
    circumradius R > h has its circumcentre in P'', farther than h/2 from the boundary of
    P''. No visibility and no constrained triangulation is needed. The proof is shorter
    than theory.md's (no 120-degree angles): a segment AB between a corner x of t and
    the centre would have to be crossed at some z, and |xz| + |zc| > R. *)
From Coq Require Import Reals Lra Psatz List Classical_Prop.
From Confidel.lemmas Require Import Space ChewClearance.
Open Scope R_scope.

Lemma along_dist2_left x c s : dist2 x (along x c s) = s * s * dist2 x c.
Proof. vring. Qed.
Lemma along_dist2_right x c s : dist2 c (along x c s) = (1 - s) * (1 - s) * dist2 x c.
Proof. vring. Qed.

(** Both ends of AB at least h from x and at least R > h from c, |AB| <= sqrt 3 h,
    |xc| <= R: AB does not meet the segment xc. In any dimension. *)
Theorem segment_does_not_separate x c A B h R s t : 0 < h -> h < R ->
  dist2 x c <= R * R -> h * h <= dist2 x A -> h * h <= dist2 x B ->
  R * R <= dist2 c A -> R * R <= dist2 c B -> dist2 A B <= 3 * (h * h) ->
  0 <= s <= 1 -> 0 <= t <= 1 -> along x c s = along A B t -> False.
Proof.
  intros Hh HR D XA XB CA CB L Hs Ht E.
  pose proof (segment_clearance_closed x A B t (h * h) (3 * (h * h)) Ht XA XB L) as P.
  pose proof (segment_clearance_closed c A B t (R * R) (3 * (h * h)) Ht CA CB L) as Q.
  rewrite <- E, along_dist2_left in P. rewrite <- E, along_dist2_right in Q.
  rewrite <- dist_sqr in D, P, Q. pose proof (dist_nonneg x c) as N. set (k := dist x c) in *.
  assert (K : k <= R) by (apply sq_le; lra).
  assert (P' : h / 2 <= s * k).
  { apply sq_le; [apply Rmult_le_pos; lra|]. replace (s * k * (s * k)) with (s * s * (k * k)) by ring. lra. }
  assert (Q' : R - h / 2 < (1 - s) * k).
  { apply sq_lt; [apply Rmult_le_pos; lra|].
    replace ((1 - s) * k * ((1 - s) * k)) with ((1 - s) * (1 - s) * (k * k)) by ring. nra. }
  lra.
Qed.

Lemma along_convex c A B t0 t1 t2 :
  (t2 - t0) * dist2 c (along A B t1)
  = (t2 - t1) * dist2 c (along A B t0) + (t1 - t0) * dist2 c (along A B t2)
    - (t2 - t0) * (t2 - t1) * (t1 - t0) * dist2 A B.
Proof. vring. Qed.

(** The chord that a line cuts from a disk lies on AB, when A and B are not in the open
    disk and AB meets it. *)
Lemma chord_on_segment c A B R2 t0 t : 0 <= t0 <= 1 ->
  R2 <= dist2 c A -> R2 <= dist2 c B -> dist2 c (along A B t0) < R2 ->
  dist2 c (along A B t) <= R2 -> 0 <= t <= 1.
Proof.
  intros H0 CA CB I0 I. pose proof (dist2_nonneg A B) as N.
  assert (EA : along A B 0 = A) by (veq; ring). assert (EB : along A B 1 = B) by (veq; ring).
  split.
  - destruct (Rle_lt_dec 0 t) as [L|L]; [exact L|exfalso].
    pose proof (along_convex c A B t 0 t0) as C. rewrite EA in C.
    assert (0 <= (t0 - t) * (t0 - 0) * (0 - t) * dist2 A B).
    { repeat apply Rmult_le_pos; lra. }
    nra.
  - destruct (Rle_lt_dec t 1) as [L|L]; [exact L|exfalso].
    pose proof (along_convex c A B t0 1 t) as C. rewrite EB in C.
    assert (0 <= (t - t0) * (t - 1) * (1 - t0) * dist2 A B).
    { repeat apply Rmult_le_pos; lra. }
    nra.
Qed.

(** Barycentric combination; interior points of a triangle have positive weights. *)
Definition bary (a b c : vec) (i j k : R) := vadd (vscale i a) (vadd (vscale j b) (vscale k c)).
Definition open_triangle a b c y :=
  exists i j k, 0 < i /\ 0 < j /\ 0 < k /\ i + j + k = 1 /\ y = bary a b c i j k.

Lemma bary_dist2 a b c o i j k : i + j + k = 1 ->
  dist2 o (bary a b c i j k) = i * dist2 o a + j * dist2 o b + k * dist2 o c
    - i * j * dist2 a b - i * k * dist2 a c - j * k * dist2 b c.
Proof. intros H. assert (i = 1 - j - k) by lra. subst i. vring. Qed.

Lemma open_triangle_in_disk a b c o R2 y : dist2 o a = R2 -> dist2 o b = R2 -> dist2 o c = R2 ->
  0 < dist2 a b -> open_triangle a b c y -> dist2 o y < R2.
Proof.
  intros A B C N (i & j & k & Hi & Hj & Hk & S & ->). rewrite bary_dist2 by exact S.
  rewrite A, B, C. pose proof (dist2_nonneg a c). pose proof (dist2_nonneg b c).
  assert (0 < i * j * dist2 a b) by (repeat apply Rmult_lt_0_compat; lra).
  assert (0 <= i * k * dist2 a c) by (repeat apply Rmult_le_pos; lra).
  assert (0 <= j * k * dist2 b c) by (repeat apply Rmult_le_pos; lra).
  replace (i * R2 + j * R2 + k * R2) with ((i + j + k) * R2) by ring. rewrite S. lra.
Qed.

(** Moving from an interior point towards a corner stays in the interior. *)
Lemma towards_corner a b c y s x : open_triangle a b c y -> 0 <= s < 1 ->
  x = a \/ x = b \/ x = c -> open_triangle a b c (along y x s).
Proof.
  intros (i & j & k & Hi & Hj & Hk & S & ->) Hs X.
  assert (P : forall u, 0 < u -> 0 < (1 - s) * u) by (intros; apply Rmult_lt_0_compat; lra).
  pose proof (P i Hi). pose proof (P j Hj). pose proof (P k Hk).
  destruct X as [->|[->| ->]];
    [exists ((1 - s) * i + s), ((1 - s) * j), ((1 - s) * k)
    |exists ((1 - s) * i), ((1 - s) * j + s), ((1 - s) * k)
    |exists ((1 - s) * i), ((1 - s) * j), ((1 - s) * k + s)];
    repeat split; try lra; try (replace i with (1 - j - k) by lra; ring); unfold bary; veq.
Qed.

(** The side of a point with respect to the line through A with normal w. *)
Definition side w A x := dot w (vsub x A).
Lemma side_along w A x y s : side w A (along x y s) = (1 - s) * side w A x + s * side w A y.
Proof. unfold side. vring. Qed.

(** One corner and one segment: if the interior of t avoids AB, the segment from an
    interior point y to the centre does not cross AB. *)
Lemma boundary_segment_not_crossed a b c o A B w h R y x s t : 0 < h -> h < R ->
  dist2 o a = R * R -> dist2 o b = R * R -> dist2 o c = R * R -> 0 < dist2 a b ->
  (x = a \/ x = b \/ x = c) -> h * h <= dist2 x A -> h * h <= dist2 x B ->
  R * R <= dist2 o A -> R * R <= dist2 o B -> dist2 A B <= 3 * (h * h) ->
  side w A B = 0 ->
  (* in the plane of the face the line AB is where the side vanishes *)
  (forall u v q, side w A (along u v q) = 0 -> (u = y \/ u = x) -> (v = o \/ v = x) ->
     exists q', along u v q = along A B q') ->
  open_triangle a b c y ->
  (forall u, open_triangle a b c u -> ~ on_segment A B u) ->
  0 <= s <= 1 -> 0 <= t <= 1 -> along y o s = along A B t -> False.
Proof.
  intros Hh HR OA OB OC AB X XA XB CA CB L W0 LINE Y AVOID Hs Ht E.
  assert (DX : dist2 o x = R * R) by (destruct X as [->|[->| ->]]; assumption).
  assert (DY : dist2 o y < R * R) by (apply (open_triangle_in_disk a b c); assumption).
  assert (DZ : dist2 o (along A B t) < R * R).
  { rewrite <- E, along_dist2_right, dist2_sym. pose proof (dist2_nonneg o y).
    assert ((1 - s) * (1 - s) <= 1) by nra. assert (0 <= (1 - s) * (1 - s)) by nra. nra. }
  assert (CH : forall q, dist2 o (along A B q) <= R * R -> on_segment A B (along A B q)).
  { intros q I. exists q. split; [|reflexivity]. apply (chord_on_segment o A B (R * R) t); assumption. }
  assert (SZ : side w A (along A B t) = 0).
  { rewrite side_along, W0. unfold side. replace (vsub A A) with vzero by (veq). rewrite dot_zero_r. ring. }
  rewrite <- E, side_along in SZ.
  (* y is not on the line *)
  assert (NY : side w A y <> 0).
  { intros Z. assert (E0 : along y o 0 = y) by veq.
    destruct (LINE y o 0) as [q Q]; [rewrite E0; exact Z|auto|auto|]. rewrite E0 in Q.
    apply (AVOID y Y). rewrite Q. apply CH. rewrite <- Q. lra. }
  assert (S0 : s <> 0).
  { intros ->. rewrite Rmult_0_l, Rminus_0_r, Rmult_1_l, Rplus_0_r in SZ. contradiction. }
  (* everything between y and x stays off the line *)
  assert (NS : 0 <= side w A y * side w A x).
  { destruct (Rle_lt_dec 0 (side w A y * side w A x)) as [G|G]; [exact G|exfalso].
    set (fy := side w A y) in *. set (fx := side w A x) in *.
    assert (D : fy - fx <> 0) by (intros Z; assert (fy = fx) by lra; nra).
    set (q := fy / (fy - fx)).
    assert (EQ : q * (fy - fx) = fy) by (unfold q; field; exact D).
    assert (Q01 : 0 <= q < 1).
    { assert (P2 : 0 < (fy - fx) * (fy - fx)) by nra.
      assert (q * ((fy - fx) * (fy - fx)) = fy * (fy - fx)) by (rewrite <- Rmult_assoc, EQ; ring).
      assert (0 < fy * fy) by nra. assert (0 < fx * fx) by nra. split; nra. }
    assert (Z : side w A (along y x q) = 0) by (rewrite side_along; fold fy fx; lra).
    destruct (LINE y x q Z) as [q' Q']; [auto|auto|].
    pose proof (towards_corner a b c y q x Y Q01 X) as T.
    apply (AVOID _ T). rewrite Q'. apply CH. rewrite <- Q'.
    apply Rlt_le, (open_triangle_in_disk a b c); assumption. }
  (* so the segment from x to o crosses the line, inside the disk, hence on AB *)
  set (fy := side w A y) in *. set (fx := side w A x) in *. set (fo := side w A o) in *.
  assert (NO : fy * fo <= 0).
  { assert (s * fo = - (1 - s) * fy) by lra.
    assert (0 <= (1 - s) * (fy * fy)) by (apply Rmult_le_pos; nra).
    assert (s * (fy * fo) <= 0) by nra. nra. }
  assert (exists q, 0 <= q <= 1 /\ side w A (along x o q) = 0) as (q & Q01 & Q).
  { destruct (Req_dec fx fo) as [EF|NF].
    - exists 0. split; [lra|]. rewrite side_along. fold fx fo.
      rewrite <- EF in NO. assert (Z : fy * fx = 0) by lra.
      apply Rmult_integral in Z. destruct Z as [Z|Z]; [contradiction|lra].
    - set (q := fx / (fx - fo)). assert (EQ : q * (fx - fo) = fx) by (unfold q; field; lra).
      exists q. split.
      + assert (0 < fy * fy) by nra.
        assert (P2 : 0 < (fx - fo) * (fx - fo)) by nra.
        assert (q * ((fx - fo) * (fx - fo)) = fx * (fx - fo)) by (rewrite <- Rmult_assoc, EQ; ring).
        assert (M : fx * fo <= 0).
        { assert (K : fy * fx * - (fy * fo) >= 0) by (apply Rle_ge, Rmult_le_pos; lra).
          assert (K2 : fy * fy * (fx * fo) <= 0) by lra. clear - H K2.
          set (m := fx * fo) in *. nra. }
        assert (0 <= fx * fx) by nra. assert (0 <= fo * fo) by nra. split; nra.
      + rewrite side_along. fold fx fo. lra. }
  destruct (LINE x o q Q) as [q' Q']; [auto|auto|].
  destruct (CH q') as (q2 & Q2 & E2).
  { rewrite <- Q', along_dist2_right, dist2_sym, DX.
    assert ((1 - q) * (1 - q) <= 1) by nra. nra. }
  apply (segment_does_not_separate x o A B h R q q2); try assumption.
  - rewrite dist2_sym. lra.
  - rewrite Q'. exact E2.
Qed.

(** ** The lemma *)

(** A planar region with boundary segments: it is left only through them. *)
Definition bounded_by (region : vec -> Prop) (boundary : list (vec * vec)) :=
  forall y o, region y -> ~ region o ->
    exists A B z, In (A, B) boundary /\ on_segment y o z /\ on_segment A B z.

(** The plane of the face through the origin of coordinates q0 with normal n: the line
    AB has side vector n x (B - A). *)
Definition in_plane n q0 x := dot n (vsub x q0) = 0.

Lemma cross_decomposition n e v : vscale (norm2 n) (cross e v)
  = vadd (vscale (dot n (cross e v)) n)
      (vadd (vscale (- dot n v) (cross n e)) (vscale (dot n e) (cross n v))).
Proof. destruct n, e, v. apply vec_eq; unfold norm2, dot, vscale, vadd, cross; simpl; ring. Qed.
Lemma parallel_decomposition e v :
  vscale (norm2 e) v = vadd (vscale (dot e v) e) (cross (cross e v) e).
Proof. destruct e, v. apply vec_eq; unfold norm2, dot, vscale, vadd, cross; simpl; ring. Qed.
Lemma vscale_cancel k p q l : k <> 0 -> vscale k p = vscale l q -> p = vscale (l / k) q.
Proof.
  destruct p, q. unfold vscale; simpl. intros K E. injection E. intros.
  apply vec_eq; simpl; apply Rmult_eq_reg_l with k; try exact K;
    match goal with H : k * ?x = _ |- k * ?x = _ => rewrite H end; field; exact K.
Qed.

Lemma line_in_plane n q0 A B z : n <> vzero -> A <> B ->
  in_plane n q0 A -> in_plane n q0 B -> in_plane n q0 z ->
  side (cross n (vsub B A)) A z = 0 -> exists q, z = along A B q.
Proof.
  intros N AB PA PB PZ S. set (e := vsub B A). set (v := vsub z A).
  assert (NE : dot n e = 0).
  { unfold e. replace (vsub B A) with (vsub (vsub B q0) (vsub A q0)) by veq. rewrite dot_sub_r.
    unfold in_plane in *. lra. }
  assert (NV : dot n v = 0).
  { unfold v. replace (vsub z A) with (vsub (vsub z q0) (vsub A q0)) by veq. rewrite dot_sub_r.
    unfold in_plane in *. lra. }
  unfold side in S. fold e v in S.
  assert (N2 : norm2 n <> 0) by (intros Z; apply N, norm2_zero, Z).
  assert (E2 : norm2 e <> 0).
  { intros Z. apply AB. apply norm2_zero in Z. unfold e, vsub, vzero in Z. injection Z.
    intros. apply vec_eq; lra. }
  (* e x v is parallel to n (both orthogonal to it), and n.(e x v) = (n x e).v = 0 *)
  assert (C : cross e v = vzero).
  { pose proof (cross_decomposition n e v) as K.
    replace (dot n (cross e v)) with (dot (cross n e) v) in K by (generalize n e v; vring).
    rewrite S, NE, NV in K.
    assert (Z : norm2 n * norm2 n * norm2 (cross e v) = 0).
    { replace (norm2 n * norm2 n * norm2 (cross e v)) with (norm2 (vscale (norm2 n) (cross e v))) by (generalize (cross e v); vring).
      rewrite K. unfold norm2, dot, vadd, vscale; simpl; ring. }
    apply norm2_zero. apply Rmult_integral in Z. destruct Z as [Z|Z]; [nra|exact Z]. }
  exists (dot e v / norm2 e).
  pose proof (parallel_decomposition e v) as K. rewrite C in K.
  replace (vadd (vscale (dot e v) e) (cross vzero e)) with (vscale (dot e v) e) in K
    by (apply vec_eq; unfold vadd, vscale, cross, vzero; simpl; ring).
  apply vscale_cancel in K; [|exact E2].
  unfold along. fold e. rewrite <- K. unfold v. apply vec_eq; unfold vadd, vsub; simpl; ring.
Qed.

Lemma in_plane_along n q0 x y s : in_plane n q0 x -> in_plane n q0 y -> in_plane n q0 (along x y s).
Proof.
  unfold in_plane. intros X Y.
  replace (dot n (vsub (along x y s) q0)) with ((1 - s) * dot n (vsub x q0) + s * dot n (vsub y q0)) by vring.
  rewrite X, Y. ring.
Qed.
Lemma in_plane_bary n q0 a b c i j k : i + j + k = 1 ->
  in_plane n q0 a -> in_plane n q0 b -> in_plane n q0 c -> in_plane n q0 (bary a b c i j k).
Proof.
  unfold in_plane. intros S A B C. assert (E : i = 1 - j - k) by lra. subst i.
  replace (dot n (vsub (bary a b c (1 - j - k) j k) q0))
    with ((1 - j - k) * dot n (vsub a q0) + j * dot n (vsub b q0) + k * dot n (vsub c q0)) by vring.
  rewrite A, B, C. ring.
Qed.

Theorem chew_clean (region : vec -> Prop) (boundary : list (vec * vec)) n q0 a b c o h R :
  0 < h -> h < R -> n <> vzero ->
  bounded_by region boundary ->
  (* boundary segments, at most sqrt 3 h long, in the plane *)
  (forall A B, In (A, B) boundary ->
     A <> B /\ in_plane n q0 A /\ in_plane n q0 B /\ dist2 A B <= 3 * (h * h)) ->
  (* t = abc: in the plane, distinct corners, interior in the region and off the boundary *)
  in_plane n q0 a -> in_plane n q0 b -> in_plane n q0 c -> in_plane n q0 o ->
  0 < dist2 a b -> 0 < dist2 a c -> 0 < dist2 b c ->
  (forall u, open_triangle a b c u -> region u) ->
  (forall A B u, In (A, B) boundary -> open_triangle a b c u -> ~ on_segment A B u) ->
  (* o is its circumcentre, R its circumradius, and the disk contains no boundary vertex *)
  dist2 o a = R * R -> dist2 o b = R * R -> dist2 o c = R * R ->
  (forall A B, In (A, B) boundary -> R * R <= dist2 o A /\ R * R <= dist2 o B) ->
  (* corners are boundary vertices or at least h from them *)
  (forall A B x, In (A, B) boundary -> x = a \/ x = b \/ x = c ->
     (x = A \/ h * h <= dist2 x A) /\ (x = B \/ h * h <= dist2 x B)) ->
  region o /\ forall A B z, In (A, B) boundary -> on_segment A B z -> h / 2 < dist o z.
Proof.
  intros Hh HR N BND SEG PA PB PC PO AB AC BC INT AVOID OA OB OC EMPTY SEP. split.
  - destruct (classic (region o)) as [G|G]; [exact G|exfalso].
    set (y := bary a b c (1/3) (1/3) (1/3)).
    assert (Y : open_triangle a b c y) by (exists (1/3), (1/3), (1/3); repeat split; try lra).
    destruct (BND y o (INT y Y) G) as (A & B & z & I & (s & Hs & ->) & (t & Ht & E)).
    destruct (SEG A B I) as (NAB & PLA & PLB & L). destruct (EMPTY A B I) as [CA CB].
    (* some corner is neither A nor B *)
    assert (exists x, (x = a \/ x = b \/ x = c) /\ h * h <= dist2 x A /\ h * h <= dist2 x B) as (x & X & XA & XB).
    { assert (Z : forall p, dist2 p p = 0) by (intros; vring).
      destruct (SEP A B a I (or_introl eq_refl)) as [[a1|a1] [a2|a2]];
      destruct (SEP A B b I (or_intror (or_introl eq_refl))) as [[b1|b1] [b2|b2]];
      destruct (SEP A B c I (or_intror (or_intror eq_refl))) as [[c1|c1] [c2|c2]];
      try (exists a; tauto); try (exists b; tauto); try (exists c; tauto); exfalso; subst; rewrite ?Z in *;
      try lra; congruence. }
    assert (PX : in_plane n q0 x) by (destruct X as [->|[->| ->]]; assumption).
    assert (PY : in_plane n q0 y) by (apply in_plane_bary; [lra|assumption|assumption|assumption]).
    apply (boundary_segment_not_crossed a b c o A B (cross n (vsub B A)) h R y x s t); try assumption.
    + unfold side. vring.
    + intros u v q SD U V. apply (line_in_plane n q0); try assumption.
      apply in_plane_along; [destruct U as [->| ->]; assumption|destruct V as [->| ->]; assumption].
    + intros u U. apply (AVOID A B u I U).
  - intros A B z I (t & Ht & ->). destruct (SEG A B I) as (_ & _ & _ & L). destruct (EMPTY A B I) as [CA CB].
    pose proof (segment_clearance o A B t (h * h) (3 * (h * h)) Ht) as K.
    assert (HH : h * h < R * R) by nra.
    specialize (K ltac:(lra) ltac:(lra) L). apply sq_lt; [apply dist_nonneg|]. rewrite dist_sqr. lra.
Qed.

(** "Farther than h from every vertex" is the empty disk itself. *)
Theorem chew_clean_far_from_vertices o h R x : h < R -> R <= dist o x -> h < dist o x.
Proof. lra. Qed.
