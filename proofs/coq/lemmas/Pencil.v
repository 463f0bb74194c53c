(** The pencil lemma and the Gabriel criterion (behind Lemma 1.2 of the paper, L16
    and L18): the spheres through three points a, b, c form a pencil, and the power of
    a point changes linearly along it at the rate of its height over the plane. *)
From Coq Require Import Reals Lra Psatz List.
From Confidel.lemmas Require Import Space.
Open Scope R_scope.

Definition normal a b c := cross (vsub b a) (vsub c a).
(** Positive above, zero on, negative below the plane of a, b, c. *)
Definition height a b c x := dot (normal a b c) (vsub x a).
Definition nondegenerate a b c := normal a b c <> vzero.
Definition equidistant o a b c := dist2 o a = dist2 o b /\ dist2 o a = dist2 o c.
(** Centre of the diametral sphere: equidistant and in the plane. *)
Definition diametral_centre o a b c := equidistant o a b c /\ height a b c o = 0.

(** A vector orthogonal to both p and q is parallel to p x q. *)
Lemma parallel_to_cross w p q m : dot w p = 0 -> dot w q = 0 ->
  dot w m * norm2 (cross p q) = dot w (cross p q) * dot (cross p q) m.
Proof.
  intros P Q. set (n := cross p q).
  (* w x (p x q) = p (w.q) - q (w.p) = 0 *)
  assert (W : cross w n = vzero).
  { unfold n. replace (cross w (cross p q)) with (vsub (vscale (dot w q) p) (vscale (dot w p) q)) by (veq; ring).
    rewrite P, Q. veq; ring. }
  (* (w.m)(n.n) - (w.n)(n.m) = (w x n).(m x n) *)
  assert (E : dot w m * norm2 n - dot w n * dot n m = dot (cross w n) (cross m n)) by vring.
  rewrite W, dot_zero_l in E. lra.
Qed.

(** Pencil lemma: for every sphere through a, b, c there is one number s such that
    the power of every x is its power for the diametral sphere minus 2 s height(x). *)
Theorem pencil a b c o0 o : nondegenerate a b c ->
  diametral_centre o0 a b c -> equidistant o a b c ->
  exists s, forall x, power o a x = power o0 a x - 2 * s * height a b c x.
Proof.
  intros N [[A1 A2] A3] [B1 B2].
  set (n := normal a b c). set (w := vsub o o0).
  assert (NN : norm2 n <> 0) by (intros Z; apply N, norm2_zero; exact Z).
  assert (E1 : dot w (vsub b a) = 0).
  { assert (2 * dot w (vsub b a) = dist2 o a - dist2 o b - (dist2 o0 a - dist2 o0 b)) by (unfold w; vring). lra. }
  assert (E2 : dot w (vsub c a) = 0).
  { assert (2 * dot w (vsub c a) = dist2 o a - dist2 o c - (dist2 o0 a - dist2 o0 c)) by (unfold w; vring). lra. }
  exists (dot w n / norm2 n). intros x.
  pose proof (parallel_to_cross w (vsub b a) (vsub c a) (vsub x a) E1 E2) as K.
  fold (normal a b c) in K. fold n in K. unfold height. fold n.
  assert (D : dot w (vsub x a) = dot w n / norm2 n * dot n (vsub x a)).
  { apply Rmult_eq_reg_r with (norm2 n); [|exact NN]. rewrite K. field. exact NN. }
  replace (2 * (dot w n / norm2 n) * dot n (vsub x a)) with (2 * dot w (vsub x a)) by (rewrite D; ring).
  unfold w. vring.
Qed.

(** Conversely every s is realised: the centre o0 + s n. *)
Theorem pencil_converse a b c o0 s : diametral_centre o0 a b c ->
  let o := vadd o0 (vscale s (normal a b c)) in
  equidistant o a b c /\ forall x, power o a x = power o0 a x - 2 * s * height a b c x.
Proof.
  intros [[A1 A2] A3] o.
  assert (P : forall x, power o a x = power o0 a x - 2 * s * height a b c x).
  { intros x. unfold o, height. set (n := normal a b c). vring. }
  assert (B : height a b c b = 0) by (unfold height, normal; vring).
  assert (C : height a b c c = 0) by (unfold height, normal; vring).
  pose proof (P b) as Pb. pose proof (P c) as Pc. rewrite B in Pb. rewrite C in Pc.
  unfold power in Pb, Pc. split; [split; lra|exact P].
Qed.

(** Two points on opposite sides of the plane exclude all spheres of the pencil when
    the one above wants the centre below t1, the one below wants it above t2 > t1. *)
Theorem pencil_exclusion a b c o0 m1 m2 : diametral_centre o0 a b c -> nondegenerate a b c ->
  0 < height a b c m1 -> height a b c m2 < 0 ->
  power o0 a m1 / (2 * height a b c m1) < power o0 a m2 / (2 * height a b c m2) ->
  forall o, equidistant o a b c -> strictly_inside o a m1 \/ strictly_inside o a m2.
Proof.
  intros D N H1 H2 T o E. destruct (pencil a b c o0 o N D E) as [s P].
  unfold strictly_inside. rewrite !P.
  set (h1 := height a b c m1) in *. set (h2 := height a b c m2) in *.
  set (p1 := power o0 a m1) in *. set (p2 := power o0 a m2) in *.
  assert (E1 : p1 / (2 * h1) * (2 * h1) = p1) by (field; lra).
  assert (E2 : p2 / (2 * h2) * (2 * h2) = p2) by (field; lra).
  set (t1 := p1 / (2 * h1)) in *. set (t2 := p2 / (2 * h2)) in *.
  destruct (Rlt_le_dec t1 s); [left; nra|right; nra].
Qed.

(** Gabriel criterion: if the spheres through a, b, c and the apexes p above and q
    below are empty, and neither apex is inside the diametral sphere, then the
    diametral sphere is empty. *)
Theorem gabriel (V : list vec) a b c p q o0 op oq :
  nondegenerate a b c -> diametral_centre o0 a b c ->
  equidistant op a b c -> power op a p = 0 -> 0 < height a b c p ->
  equidistant oq a b c -> power oq a q = 0 -> height a b c q < 0 ->
  (forall v, In v V -> ~ strictly_inside op a v) ->
  (forall v, In v V -> ~ strictly_inside oq a v) ->
  ~ strictly_inside o0 a p -> ~ strictly_inside o0 a q ->
  forall v, In v V -> ~ strictly_inside o0 a v.
Proof.
  unfold strictly_inside. intros N D Tp Ep Sp Tq Eq Sq Hp Hq Ip Iq v Hv Iv.
  destruct (pencil a b c o0 op N D Tp) as [sp Lp].
  destruct (pencil a b c o0 oq N D Tq) as [sq Lq].
  specialize (Hp v Hv). specialize (Hq v Hv).
  pose proof (Lp p) as Lpp. pose proof (Lq q) as Lqq. specialize (Lp v). specialize (Lq v).
  destruct (Rle_dec 0 (height a b c v)).
  - assert (0 <= sp) by nra. nra.
  - assert (sq <= 0) by nra. nra.
Qed.

(** On a hull face there is one apex, and all points are on its side. *)
Theorem gabriel_hull (V : list vec) a b c p o0 op :
  nondegenerate a b c -> diametral_centre o0 a b c ->
  equidistant op a b c -> power op a p = 0 -> 0 < height a b c p ->
  (forall v, In v V -> ~ strictly_inside op a v) ->
  (forall v, In v V -> 0 <= height a b c v) ->
  ~ strictly_inside o0 a p -> forall v, In v V -> ~ strictly_inside o0 a v.
Proof.
  unfold strictly_inside. intros N D Tp Ep Sp Hp Hs Ip v Hv Iv.
  destruct (pencil a b c o0 op N D Tp) as [sp Lp].
  specialize (Hp v Hv). specialize (Hs v Hv).
  pose proof (Lp p) as Lpp. specialize (Lp v). assert (0 <= sp) by nra. nra.
Qed.
