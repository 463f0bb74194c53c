(* SPDX-License-Identifier: Apache-2.0 *)
(** * Empty spheres support faces of every Delaunay subdivision

    If no point of V lies inside a sphere, then every simplex of a Delaunay subdivision that meets the hull of the points ON the sphere
    meets it in a face spanned by such points: the difference of the two powers is an affine function, and decides (Lemma 1.2 of the paper, the direction that is needed). *)
From Coq Require Import Reals Lra Psatz List.
From Confidel.checker Require Import Space Statement.
Import ListNotations.
Open Scope R_scope.

(** All that the theorem needs to know of a Delaunay subdivision. *)
Definition proper (t : simplex) := solid t \/ flat t.
Record covering (V : list point) (T : list simplex) : Prop := {
  cov_corners : forall t v, In t T -> corner t v -> In v V;
  cov_proper : forall t, In t T -> proper t;
  cov_empty : forall t, In t T -> exists o, empty_ball V t o;
  cov_covers : forall x, hull V x -> exists t, In t T /\ in_simplex t x }.

Lemma subdivision_covering (shape : simplex -> Prop) V T : (forall t, shape t -> proper t) -> subdivision shape V T -> covering V T.
Proof.
  intros P [A B C D E]. split; auto. intros x H. apply D. exact H.
Qed.

Lemma point_eq_dec : forall u w : point, u = w \/ u <> w.
Proof.
  intros [u1 u2 u3] [w1 w2 w3]. destruct (Req_dec u1 w1), (Req_dec u2 w2), (Req_dec u3 w3); subst; auto; right; congruence.
Qed.

Lemma triangle_hull : forall V a b c x, In a V -> In b V -> In c V -> in_triangle a b c x -> hull V x.
Proof.
  intros V a b c x A B C (l & m & n & Hl & Hm & Hn & S & ->).
  destruct (Req_dec n 1) as [E|N].
  - assert (l = 0) by lra. assert (m = 0) by lra. subst.
    replace (mix3 a b c 0 0 1) with c by (destruct c; unfold mix3; simpl; f_equal; ring). apply hull_in; auto.
  - assert (P : 0 < l + m) by lra. assert (I := Rinv_0_lt_compat _ P).
    replace (mix3 a b c l m n) with (towards (towards a b (m/(l+m))) c n).
    + apply hull_towards; [lra| |apply hull_in; auto]. apply hull_towards; try (apply hull_in; auto).
      split. apply Rmult_le_pos; lra.
      apply Rmult_le_reg_r with (l+m); [lra|]. replace (m/(l+m)*(l+m)) with m by (field; lra). lra.
    + assert (n = 1 - l - m) by lra. subst n. unfold mix3, towards; simpl; f_equal; field; lra.
Qed.

Section Support.
Variables (V : list point) (T : list simplex).
Hypothesis D : covering V T.

Lemma support : forall o a b c, In a V -> In b V -> In c V -> dist2 o b = dist2 o a -> dist2 o c = dist2 o a ->
  (forall v, In v V -> dist2 o a <= dist2 o v) ->
  forall x, in_triangle a b c x -> exists t, In t T /\ in_face t (fun v => dist2 o v = dist2 o a) x.
Proof.
  intros o a b c A B C Ob Oc E x Hx.
  destruct (cov_covers _ _ D x (triangle_hull V a b c x A B C Hx)) as (t & Ht & Hin). exists t. split; [exact Ht|].
  destruct (cov_empty _ _ D t Ht) as [o' Em]. pose proof (fun v => cov_corners _ _ D t v Ht) as Vc.
  unfold empty_ball in Em. destruct t as [[[p q] r] s]. cbn [corner] in *.
  destruct (Em p) as [Q Em']; [auto|].
  assert (Q1 : dist2 o' q = dist2 o' p) by auto. assert (Q2 : dist2 o' r = dist2 o' p) by auto. assert (Q3 : dist2 o' s = dist2 o' p) by auto.
  clear Q Em. rename Em' into Em.
  destruct Hx as (m1 & m2 & m3 & M1 & M2 & M3 & MS & Ex).
  destruct Hin as (l1 & l2 & l3 & l4 & L1 & L2 & L3 & L4 & LS & Ex').
  pose proof (Em a A) as Ea. pose proof (Em b B) as Eb. pose proof (Em c C) as Ec.
  pose proof (E p ltac:(auto)) as Np. pose proof (E q ltac:(auto)) as Nq. pose proof (E r ltac:(auto)) as Nr. pose proof (E s ltac:(auto)) as Ns.
  set (k := dist2 o' p - dist2 o a).
  assert (AFF3 : dist2 o x - dist2 o' x = m1*(dist2 o a - dist2 o' a) + m2*(dist2 o b - dist2 o' b) + m3*(dist2 o c - dist2 o' c)).
  { subst x. replace m3 with (1-m1-m2) by lra. unfold mix3, dist2, dot, minus; simpl. ring. }
  assert (AFF4 : dist2 o x - dist2 o' x = l1*(dist2 o p - dist2 o' p) + l2*(dist2 o q - dist2 o' q) + l3*(dist2 o r - dist2 o' r) + l4*(dist2 o s - dist2 o' s)).
  { rewrite Ex'. replace l4 with (1-l1-l2-l3) by lra. unfold mix4, dist2, dot, minus; simpl. ring. }
  rewrite Ob, Oc in AFF3. rewrite Q1, Q2, Q3 in AFF4.
  assert (U : dist2 o x - dist2 o' x + k <= 0).
  { unfold k. rewrite AFF3.
    assert (0 <= m1*(dist2 o' a - dist2 o' p)) by (apply Rmult_le_pos; lra).
    assert (0 <= m2*(dist2 o' b - dist2 o' p)) by (apply Rmult_le_pos; lra).
    assert (0 <= m3*(dist2 o' c - dist2 o' p)) by (apply Rmult_le_pos; lra).
    assert (M3' : m3 = 1-m1-m2) by lra. clear Ex. subst m3. lra. }
  assert (W : dist2 o x - dist2 o' x + k = l1*(dist2 o p - dist2 o a) + l2*(dist2 o q - dist2 o a) + l3*(dist2 o r - dist2 o a) + l4*(dist2 o s - dist2 o a)).
  { unfold k. rewrite AFF4. replace l4 with (1-l1-l2-l3) by lra. ring. }
  assert (Z1 := Rmult_le_pos l1 (dist2 o p - dist2 o a) L1 ltac:(lra)). assert (Z2 := Rmult_le_pos l2 (dist2 o q - dist2 o a) L2 ltac:(lra)).
  assert (Z3 := Rmult_le_pos l3 (dist2 o r - dist2 o a) L3 ltac:(lra)). assert (Z4 := Rmult_le_pos l4 (dist2 o s - dist2 o a) L4 ltac:(lra)).
  assert (fin : forall l v, l*(dist2 o v - dist2 o a) = 0 -> l = 0 \/ dist2 o v = dist2 o a).
  { intros l v H0. apply Rmult_integral in H0. destruct H0; [left|right]; lra. }
  exists l1, l2, l3, l4. repeat (split; [assumption|]).
  repeat split; apply fin; lra.
Qed.

(** A linear function that is zero at a and b and positive at all other points of the sphere: a b is an edge of every subdivision. *)
Lemma support_edge : forall o a b g, In a V -> In b V -> a <> b -> dist2 o b = dist2 o a ->
  (forall v, In v V -> dist2 o a <= dist2 o v) -> dot g (minus b a) = 0 ->
  (forall v, In v V -> dist2 o v = dist2 o a -> 0 <= dot g (minus v a) /\ (dot g (minus v a) = 0 -> v = a \/ v = b)) ->
  edge_of T a b.
Proof.
  intros o a b g A B N Ob E Gb G.
  destruct (support o a b b A B B Ob Ob E (towards a b (1/2))) as (t & Ht & F).
  { exists (1/2), (1/2), 0. repeat split; try lra. unfold towards, mix3; f_equal; field. }
  split; [exact N|]. exists t. split; [exact Ht|].
  pose proof (fun v => cov_corners _ _ D t v Ht) as Vc.
  destruct t as [[[p q] r] s]. cbn [corner] in *.
  destruct F as (l1 & l2 & l3 & l4 & L1 & L2 & L3 & L4 & LS & Ex & F1 & F2 & F3 & F4).
  assert (Z : l1 * dot g (minus p a) + l2 * dot g (minus q a) + l3 * dot g (minus r a) + l4 * dot g (minus s a) = 0).
  { transitivity (dot g (minus (towards a b (1/2)) a)).
    - rewrite Ex. replace l4 with (1-l1-l2-l3) by lra. unfold mix4, dot, minus; simpl. ring.
    - transitivity (1/2 * dot g (minus b a)); [unfold towards, dot, minus; simpl; field|]. rewrite Gb. ring. }
  assert (pos : forall l v, 0 <= l -> In v V -> l = 0 \/ dist2 o v = dist2 o a -> 0 <= l * dot g (minus v a)).
  { intros l v Hl Hv [->|H]; [lra|]. apply Rmult_le_pos; [exact Hl|]. apply (G v Hv H). }
  pose proof (pos l1 p L1 ltac:(auto) F1). pose proof (pos l2 q L2 ltac:(auto) F2).
  pose proof (pos l3 r L3 ltac:(auto) F3). pose proof (pos l4 s L4 ltac:(auto) F4).
  assert (fin : forall l v, In v V -> l = 0 \/ dist2 o v = dist2 o a -> l * dot g (minus v a) = 0 -> l = 0 \/ v = a \/ v = b).
  { intros l v Hv [->|H'] K; [auto|]. apply Rmult_integral in K. destruct K as [K|K]; [auto|]. right. apply (G v Hv H'). exact K. }
  assert (K1 : l1 = 0 \/ p = a \/ p = b) by (apply fin; auto; lra).
  assert (K2 : l2 = 0 \/ q = a \/ q = b) by (apply fin; auto; lra).
  assert (K3 : l3 = 0 \/ r = a \/ r = b) by (apply fin; auto; lra).
  assert (K4 : l4 = 0 \/ s = a \/ s = b) by (apply fin; auto; lra).
  assert (only : forall u w : point, u <> w -> (l1 = 0 \/ p = u) -> (l2 = 0 \/ q = u) -> (l3 = 0 \/ r = u) -> (l4 = 0 \/ s = u) ->
       towards u w (1/2) = mix4 p q r s l1 l2 l3 l4 -> False).
  { clear - LS. intros u w Nu G1 G2 G3 G4 Eq.
    assert (Eq2 : mix4 p q r s l1 l2 l3 l4 = u).
    { assert (R1 : forall f : point -> R, l1 * f p = l1 * f u) by (intro f; destruct G1 as [->| ->]; ring).
      assert (R2 : forall f : point -> R, l2 * f q = l2 * f u) by (intro f; destruct G2 as [->| ->]; ring).
      assert (R3 : forall f : point -> R, l3 * f r = l3 * f u) by (intro f; destruct G3 as [->| ->]; ring).
      assert (R4 : forall f : point -> R, l4 * f s = l4 * f u) by (intro f; destruct G4 as [->| ->]; ring).
      unfold mix4. rewrite (R1 cx), (R1 cy), (R1 cz), (R2 cx), (R2 cy), (R2 cz), (R3 cx), (R3 cy), (R3 cz), (R4 cx), (R4 cy), (R4 cz).
      replace l4 with (1-l1-l2-l3) by lra. destruct u; simpl; f_equal; ring. }
    rewrite Eq2 in Eq. apply Nu. destruct u as [u1 u2 u3], w as [w1 w2 w3]. unfold towards in Eq; simpl in Eq.
    injection Eq; intros. f_equal; lra. }
  assert (M : towards a b (1/2) = towards b a (1/2)) by (unfold towards; f_equal; field).
  assert (ia : forall l (v : point), (l = 0 \/ v = a \/ v = b) -> v <> a -> l = 0 \/ v = b) by (clear; intros; tauto).
  assert (ib : forall l (v : point), (l = 0 \/ v = a \/ v = b) -> v <> b -> l = 0 \/ v = a) by (clear; intros; tauto).
  split.
  - destruct (point_eq_dec a p); [auto|]. destruct (point_eq_dec a q); [auto|]. destruct (point_eq_dec a r); [auto|]. destruct (point_eq_dec a s); [auto|].
    exfalso. rewrite M in Ex. apply (only b a); auto.
  - destruct (point_eq_dec b p); [auto|]. destruct (point_eq_dec b q); [auto|]. destruct (point_eq_dec b r); [auto|]. destruct (point_eq_dec b s); [auto|].
    exfalso. apply (only a b); auto.
Qed.

(** Every point of V is a vertex. *)
Lemma all_vertices : forall v, In v V -> vertex_of T v.
Proof.
  intros v Hv. destruct (cov_covers _ _ D v (hull_in V v Hv)) as (t & Ht & Hin). exists t. split; [exact Ht|].
  destruct (cov_empty _ _ D t Ht) as [o Em]. unfold empty_ball in Em. destruct t as [[[p q] r] s]. cbn [corner] in *.
  destruct (Em p) as [Q E]; [auto|]. specialize (E v Hv).
  assert (Q1 : dist2 o q = dist2 o p) by auto. assert (Q2 : dist2 o r = dist2 o p) by auto. assert (Q3 : dist2 o s = dist2 o p) by auto.
  destruct Hin as (l1 & l2 & l3 & l4 & L1 & L2 & L3 & L4 & LS & Ex).
  assert (S : l1 * dist2 v p + l2 * dist2 v q + l3 * dist2 v r + l4 * dist2 v s = dist2 o p - dist2 o v).
  { transitivity (l1 * dist2 o p + l2 * dist2 o q + l3 * dist2 o r + l4 * dist2 o s - dist2 o v).
    - rewrite Ex. replace l4 with (1-l1-l2-l3) by lra. unfold mix4, dist2, dot, minus; simpl. ring.
    - rewrite Q1, Q2, Q3. replace l4 with (1-l1-l2-l3) by lra. ring. }
  assert (nn : forall a b, 0 <= dist2 a b).
  { intros a b. unfold dist2, dot. pose proof (Rle_0_sqr (cx (minus a b))). pose proof (Rle_0_sqr (cy (minus a b))). pose proof (Rle_0_sqr (cz (minus a b))). unfold Rsqr in *. lra. }
  assert (z : forall a b, dist2 a b = 0 -> a = b).
  { intros [a1 a2 a3] [b1 b2 b3]. unfold dist2, dot, minus; simpl. intro H.
    pose proof (Rle_0_sqr (a1-b1)) as H1. pose proof (Rle_0_sqr (a2-b2)) as H2. pose proof (Rle_0_sqr (a3-b3)) as H3. unfold Rsqr in *.
    assert (I1 : (a1-b1)*(a1-b1) = 0) by lra. assert (I2 : (a2-b2)*(a2-b2) = 0) by lra. assert (I3 : (a3-b3)*(a3-b3) = 0) by lra.
    apply Rmult_integral in I1, I2, I3. f_equal; lra. }
  pose proof (Rmult_le_pos _ _ L1 (nn v p)). pose proof (Rmult_le_pos _ _ L2 (nn v q)).
  pose proof (Rmult_le_pos _ _ L3 (nn v r)). pose proof (Rmult_le_pos _ _ L4 (nn v s)).
  assert (P : forall l w, 0 < l -> l * dist2 v w = 0 -> v = w).
  { intros l w Hl H'. apply z. apply Rmult_integral in H'. lra. }
  destruct (Req_dec l1 0) as [E1|E1]; [|left; apply (P l1); lra].
  destruct (Req_dec l2 0) as [E2|E2]; [|right; left; apply (P l2); lra].
  destruct (Req_dec l3 0) as [E3|E3]; [|right; right; left; apply (P l3); lra].
  right; right; right. apply (P l4); lra.
Qed.
End Support.
