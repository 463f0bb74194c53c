(* SPDX-License-Identifier: Apache-2.0 *)
(** * A plane in space: orientation, triangles, spheres through points of the plane; affine functions on a segment *)
From Coq Require Import Reals Lra Psatz List.
From Confidel.checker Require Import Space Statement.
Import ListNotations.
Open Scope R_scope.

Lemma dot_self_pos : forall n, n <> origin -> 0 < dot n n.
Proof.
  intros [x y z] H. unfold dot; simpl. pose proof (Rle_0_sqr x). pose proof (Rle_0_sqr y). pose proof (Rle_0_sqr z). unfold Rsqr in *.
  destruct (Req_dec x 0); [|pose proof (Rsqr_pos_lt x); unfold Rsqr in *; lra].
  destruct (Req_dec y 0); [|pose proof (Rsqr_pos_lt y); unfold Rsqr in *; lra].
  destruct (Req_dec z 0); [|pose proof (Rsqr_pos_lt z); unfold Rsqr in *; lra].
  exfalso. apply H. subst. reflexivity.
Qed.
Lemma dist2_nonneg : forall a b, 0 <= dist2 a b.
Proof.
  intros. unfold dist2, dot. pose proof (Rle_0_sqr (cx (minus a b))). pose proof (Rle_0_sqr (cy (minus a b))). pose proof (Rle_0_sqr (cz (minus a b))). unfold Rsqr in *. lra.
Qed.
Lemma dist2_zero : forall a b, dist2 a b = 0 -> a = b.
Proof.
  intros [a1 a2 a3] [b1 b2 b3]. unfold dist2, dot, minus; simpl. intro H.
  pose proof (Rle_0_sqr (a1-b1)) as H1. pose proof (Rle_0_sqr (a2-b2)) as H2. pose proof (Rle_0_sqr (a3-b3)) as H3. unfold Rsqr in *.
  assert (I1 : (a1-b1)*(a1-b1) = 0) by lra. assert (I2 : (a2-b2)*(a2-b2) = 0) by lra. assert (I3 : (a3-b3)*(a3-b3) = 0) by lra.
  apply Rmult_integral in I1, I2, I3. f_equal; lra.
Qed.

(** The power of x with respect to the sphere with centre z through a. *)
Definition pow z a x := dist2 z x - dist2 z a.
Lemma pow_towards : forall z a x y t, pow z a (towards x y t) = (1-t) * pow z a x + t * pow z a y - t*(1-t) * dist2 x y.
Proof. intros. unfold pow, towards, dist2, dot, minus; simpl. ring. Qed.
Lemma pow_mix3 : forall z a p q r l m n, l + m + n = 1 ->
  pow z a (mix3 p q r l m n) = l * pow z a p + m * pow z a q + n * pow z a r - (l*m*dist2 p q + m*n*dist2 q r + n*l*dist2 r p).
Proof. intros. replace n with (1-l-m) by lra. unfold pow, mix3, dist2, dot, minus; simpl. ring. Qed.

Section Plane.
Variables (o n : point).
Hypothesis n0 : n <> origin.
Definition flat_at x := dot n (minus x o) = 0.
Definition turn u v x := dot n (cross (minus v u) (minus x u)).

Lemma turn_rot : forall a b c, turn b c a = turn a b c.
Proof. intros. unfold turn, dot, cross, minus; simpl. ring. Qed.
Lemma turn_swap : forall a b c, turn b a c = - turn a b c.
Proof. intros. unfold turn, dot, cross, minus; simpl. ring. Qed.
Lemma turn_same : forall a b, turn a b a = 0.
Proof. intros. unfold turn, dot, cross, minus; simpl. ring. Qed.
Lemma turn_same' : forall a b, turn a b b = 0.
Proof. intros. unfold turn, dot, cross, minus; simpl. ring. Qed.
Lemma turn_refl : forall a b, turn a a b = 0.
Proof. intros. unfold turn, dot, cross, minus; simpl. ring. Qed.
Lemma turn_sum : forall a b c x, turn a b x + turn b c x + turn c a x = turn a b c.
Proof. intros. unfold turn, dot, cross, minus; simpl. ring. Qed.
Lemma turn_towards : forall u v x y t, turn u v (towards x y t) = (1-t) * turn u v x + t * turn u v y.
Proof. intros. unfold turn, towards, dot, cross, minus; simpl. ring. Qed.
Lemma turn_mix3 : forall u v a b c l m k, l + m + k = 1 -> turn u v (mix3 a b c l m k) = l * turn u v a + m * turn u v b + k * turn u v c.
Proof. intros. replace k with (1-l-m) by lra. unfold turn, mix3, dot, cross, minus; simpl. ring. Qed.
Lemma flat_towards : forall x y t, flat_at x -> flat_at y -> flat_at (towards x y t).
Proof.
  unfold flat_at. intros x y t A B. transitivity ((1-t) * dot n (minus x o) + t * dot n (minus y o)); [unfold towards, dot, minus; simpl; ring|].
  rewrite A, B. ring.
Qed.
Lemma flat_mix3 : forall a b c l m k, l + m + k = 1 -> flat_at a -> flat_at b -> flat_at c -> flat_at (mix3 a b c l m k).
Proof.
  unfold flat_at. intros a b c l m k S A B C. replace k with (1-l-m) by lra.
  transitivity (l * dot n (minus a o) + m * dot n (minus b o) + (1-l-m) * dot n (minus c o)); [unfold mix3, dot, minus; simpl; ring|].
  rewrite A, B, C. ring.
Qed.

(** barycentric coordinates, times twice the area *)
Lemma bary : forall a b c x, flat_at a -> flat_at b -> flat_at c -> flat_at x ->
  turn a b c * cx x = turn b c x * cx a + turn c a x * cx b + turn a b x * cx c /\
  turn a b c * cy x = turn b c x * cy a + turn c a x * cy b + turn a b x * cy c /\
  turn a b c * cz x = turn b c x * cz a + turn c a x * cz b + turn a b x * cz c.
Proof.
  intros a b c x A B C X.
  assert (P : dot n (minus b a) = 0) by (unfold flat_at, dot, minus in *; simpl in *; lra).
  assert (Q : dot n (minus c a) = 0) by (unfold flat_at, dot, minus in *; simpl in *; lra).
  assert (S : dot n (minus x a) = 0) by (unfold flat_at, dot, minus in *; simpl in *; lra).
  assert (N : 0 < dot n n) by (apply dot_self_pos; exact n0).
  set (p := minus b a) in *. set (q := minus c a) in *. set (r := minus x a) in *.
  set (det := dot p (cross q r)).
  assert (E : dot n n * det = 0).
  { transitivity (dot n p * dot n (cross q r) + dot n q * dot n (cross r p) + dot n r * dot n (cross p q)).
    - unfold det, dot, cross; simpl. ring.
    - rewrite P, Q, S. ring. }
  assert (Z : det = 0) by (apply Rmult_integral in E; lra).
  assert (T1 : turn a b c = dot n (cross p q)) by reflexivity.
  assert (T2 : turn b c x = dot n (cross p q) - dot n (cross p r) - dot n (cross r q)) by (unfold turn, p, q, r, dot, cross, minus; simpl; ring).
  assert (T3 : turn c a x = dot n (cross r q)) by (unfold turn, p, q, r, dot, cross, minus; simpl; ring).
  assert (T4 : turn a b x = dot n (cross p r)) by reflexivity.
  rewrite T1, T2, T3, T4.
  assert (Ex : cx x = cx a + cx r /\ cy x = cy a + cy r /\ cz x = cz a + cz r) by (unfold r, minus; simpl; repeat split; ring).
  assert (Eb : cx b = cx a + cx p /\ cy b = cy a + cy p /\ cz b = cz a + cz p) by (unfold p, minus; simpl; repeat split; ring).
  assert (Ec : cx c = cx a + cx q /\ cy c = cy a + cy q /\ cz c = cz a + cz q) by (unfold q, minus; simpl; repeat split; ring).
  destruct Ex as (-> & -> & ->), Eb as (-> & -> & ->), Ec as (-> & -> & ->).
  clearbody p q r. clear T1 T2 T3 T4 P Q S E A B C X b c x. destruct p as [p1 p2 p3], q as [q1 q2 q3], r as [r1 r2 r3], n as [n1 n2 n3], a as [a1 a2 a3].
  unfold det, dot, cross in *; simpl in *.
  repeat split.
  - apply Rminus_diag_uniq. transitivity (n1 * (p1 * (q2 * r3 - q3 * r2) + p2 * (q3 * r1 - q1 * r3) + p3 * (q1 * r2 - q2 * r1))); [ring|rewrite Z; ring].
  - apply Rminus_diag_uniq. transitivity (n2 * (p1 * (q2 * r3 - q3 * r2) + p2 * (q3 * r1 - q1 * r3) + p3 * (q1 * r2 - q2 * r1))); [ring|rewrite Z; ring].
  - apply Rminus_diag_uniq. transitivity (n3 * (p1 * (q2 * r3 - q3 * r2) + p2 * (q3 * r1 - q1 * r3) + p3 * (q1 * r2 - q2 * r1))); [ring|rewrite Z; ring].
Qed.

(** a closed triangle, by its sides *)
Definition within a b c x := flat_at x /\ 0 <= turn a b x /\ 0 <= turn b c x /\ 0 <= turn c a x.
Lemma within_rot : forall a b c x, within a b c x -> within b c a x.
Proof. unfold within. tauto. Qed.
Lemma within_triangle : forall a b c x, flat_at a -> flat_at b -> flat_at c -> 0 < turn a b c -> within a b c x -> in_triangle a b c x.
Proof.
  intros a b c x A B C D (F & H1 & H2 & H3). pose proof (turn_sum a b c x) as S.
  destruct (bary a b c x A B C F) as (E1 & E2 & E3). assert (I := Rinv_0_lt_compat _ D).
  exists (turn b c x / turn a b c), (turn c a x / turn a b c), (turn a b x / turn a b c).
  repeat split; try (apply Rmult_le_pos; lra).
  - replace (turn b c x / turn a b c + turn c a x / turn a b c + turn a b x / turn a b c) with ((turn a b x + turn b c x + turn c a x) / turn a b c) by (field; lra).
    rewrite S. field. lra.
  - destruct x as [x1 x2 x3]. unfold mix3; simpl in *. f_equal; apply (Rmult_eq_reg_l (turn a b c)); try lra.
    + rewrite E1. field. lra. + rewrite E2. field. lra. + rewrite E3. field. lra.
Qed.
Lemma triangle_within : forall a b c x, flat_at a -> flat_at b -> flat_at c -> 0 <= turn a b c -> in_triangle a b c x -> within a b c x.
Proof.
  intros a b c x A B C D (l & m & k & Hl & Hm & Hk & S & ->). split; [apply flat_mix3; auto|].
  rewrite !turn_mix3 by exact S. rewrite !turn_same, !turn_same'.
  rewrite (turn_rot b c a), (turn_rot a b c).
  pose proof (Rmult_le_pos _ _ Hl D). pose proof (Rmult_le_pos _ _ Hm D). pose proof (Rmult_le_pos _ _ Hk D).
  repeat split; lra.
Qed.
Lemma turn_flat_third : forall u v, u <> v -> flat_at u -> flat_at v -> exists w, flat_at w /\ turn u v w <> 0.
Proof.
  intros u v N U W. exists (Point (cx u + cx (cross n (minus v u))) (cy u + cy (cross n (minus v u))) (cz u + cz (cross n (minus v u)))).
  assert (P : 0 < dot n n) by (apply dot_self_pos; exact n0).
  assert (Q : 0 < dist2 v u).
  { destruct (Req_dec (dist2 v u) 0) as [E|E]; [exfalso; apply N; symmetry; apply dist2_zero; exact E|]. pose proof (dist2_nonneg v u). lra. }
  assert (S : dot n (minus v u) = 0) by (unfold flat_at, dot, minus in *; simpl in *; lra).
  split.
  - unfold flat_at in *. transitivity (dot n (minus u o)); [unfold dot, cross, minus; simpl; ring|exact U].
  - assert (E : turn u v (Point (cx u + cx (cross n (minus v u))) (cy u + cy (cross n (minus v u))) (cz u + cz (cross n (minus v u)))) = dot n n * dist2 v u - dot n (minus v u) * dot n (minus v u))
      by (unfold turn, dist2, dot, cross, minus; simpl; ring).
    rewrite E, S. pose proof (Rmult_lt_0_compat _ _ P Q). lra.
Qed.
(** a line of the plane that contains all three corners of a triangle does not exist *)
Lemma turn_some_corner : forall u v a b c, u <> v -> flat_at u -> flat_at v -> flat_at a -> flat_at b -> flat_at c ->
  turn a b c <> 0 -> turn u v a <> 0 \/ turn u v b <> 0 \/ turn u v c <> 0.
Proof.
  intros u v a b c N U W A B C D. destruct (Req_dec (turn u v a) 0) as [Ea|]; [|auto]. destruct (Req_dec (turn u v b) 0) as [Eb|]; [|auto].
  destruct (Req_dec (turn u v c) 0) as [Ec|]; [|auto]. exfalso.
  destruct (turn_flat_third u v N U W) as (w & Fw & Nw). destruct (bary a b c w A B C Fw) as (E1 & E2 & E3).
  pose proof (turn_sum a b c w) as S. apply Nw. apply (Rmult_eq_reg_l (turn a b c)); [|exact D]. rewrite Rmult_0_r.
  transitivity (turn b c w * turn u v a + turn c a w * turn u v b + turn a b w * turn u v c); [|rewrite Ea, Eb, Ec; ring].
  assert (lin : forall p, turn u v p = dot (cross n (minus v u)) (minus p u)) by (intro; unfold turn, dot, cross, minus; simpl; ring).
  rewrite !lin. clear lin Ea Eb Ec. generalize (cross n (minus v u)). intros g. clear - E1 E2 E3 S.
  revert E1 E2 E3 S. generalize (turn a b w) (turn b c w) (turn c a w) (turn a b c). intros t3 t1 t2 d E1 E2 E3 S. unfold dot, minus; simpl.
  transitivity (cx g * (d * cx w) + cy g * (d * cy w) + cz g * (d * cz w) - d * (cx g * cx u + cy g * cy u + cz g * cz u)); [ring|].
  rewrite E1, E2, E3, <- S. ring.
Qed.
End Plane.

(** ** Affine functions on [0,1], as pairs of their values at 0 and at 1 *)
Definition val (f : R * R) t := (1-t) * fst f + t * snd f.
Lemma small_positive : forall fs : list (R * R), (forall f, In f fs -> 0 < fst f) ->
  exists e, 0 < e < 1 /\ forall t f, 0 <= t <= e -> In f fs -> 0 < val f t.
Proof.
  induction fs as [|[p r] fs IH]; intro H; [exists (1/2); split; [lra|intros ? ? ? []]|].
  destruct IH as (e & He & G); [intros; apply H; right; auto|].
  assert (Hp : 0 < p) by (apply (H (p, r)); left; reflexivity).
  assert (Hq : 0 < p + Rabs r + 1) by (pose proof (Rabs_pos r); lra).
  assert (I := Rinv_0_lt_compat _ Hq). set (e' := p / (p + Rabs r + 1)).
  assert (P1 : 0 < e') by (apply Rmult_lt_0_compat; lra).
  assert (P2 : e' * (p + Rabs r + 1) = p) by (unfold e'; field; lra).
  exists (Rmin e e'). split; [split; [apply Rmin_pos; lra|apply Rle_lt_trans with e; [apply Rmin_l|lra]]|].
  intros t f [T0 T1] [<-|F].
  - unfold val; simpl. assert (t <= e') by (eapply Rle_trans; [exact T1|apply Rmin_r]).
    assert (t * (p + Rabs r + 1) <= e' * (p + Rabs r + 1)) by (apply Rmult_le_compat_r; lra).
    pose proof (Rle_abs (- r)) as Ra. rewrite Rabs_Ropp in Ra. assert (0 <= t * (r + Rabs r)) by (apply Rmult_le_pos; lra).
    destruct (Req_dec t 0); [subst; lra|]. assert (0 < t) by lra. lra.
  - apply G; auto. split; [lra|]. eapply Rle_trans; [exact T1|apply Rmin_l].
Qed.
Lemma small_nonzero : forall fs : list (R * R), (forall f, In f fs -> fst f <> 0) ->
  exists e, 0 < e < 1 /\ forall t f, 0 <= t <= e -> In f fs -> val f t <> 0.
Proof.
  intros fs H.
  destruct (small_positive (map (fun f => (fst f * fst f, fst f * snd f)) fs)) as (e & He & G).
  - intros f F. apply in_map_iff in F. destruct F as (f' & <- & F). simpl. pose proof (Rsqr_pos_lt (fst f') (H _ F)). unfold Rsqr in *. lra.
  - exists e. split; [exact He|]. intros t f Ht F E. specialize (G t _ Ht (in_map _ _ f F)). unfold val in *; simpl in *.
    replace ((1-t)*(fst f * fst f) + t*(fst f * snd f)) with (fst f * ((1-t)*fst f + t*snd f)) in G by ring. rewrite E in G. lra.
Qed.
(** All are non-negative at t0 and some are negative at 1: one is the first to become zero. *)
Lemma first_exit : forall (fs : list (R * R)) t0, 0 <= t0 < 1 -> (forall f, In f fs -> 0 <= val f t0) ->
  (forall f, In f fs -> 0 <= snd f) \/
  exists t1 f, t0 <= t1 < 1 /\ In f fs /\ val f t1 = 0 /\ snd f < 0 /\ forall g, In g fs -> 0 <= val g t1.
Proof.
  intros fs t0 H0. induction fs as [|g fs IH]; intro H; [left; intros ? []|].
  assert (Hg : 0 <= val g t0) by (apply H; left; reflexivity).
  (* an affine function that is >= 0 at t0 and negative at t1 > t0, or at 1, has a root *)
  assert (root : forall t1, t0 <= t1 <= 1 -> val g t1 < 0 -> exists t, t0 <= t < t1 /\ val g t = 0 /\ snd g < 0).
  { intros t1 H1 N. unfold val in *. destruct g as [p r]; simpl in *.
    set (k := (1-t0)*p + t0*r) in *. set (j := (1-t1)*p + t1*r) in *.
    assert (D : 0 < k - j) by lra. assert (I := Rinv_0_lt_compat _ D). assert (Q : 0 <= k / (k-j) < 1).
    { split; [apply Rmult_le_pos; lra|]. apply (Rmult_lt_reg_r (k-j)); [exact D|]. replace (k/(k-j)*(k-j)) with k by (field; lra). lra. }
    assert (T : t0 < t1) by (destruct (Req_dec t0 t1) as [E|]; [exfalso; unfold k, j in *; subst t1; lra|lra]).
    exists (t0 + k/(k-j)*(t1-t0)). assert (0 <= k/(k-j)*(t1-t0)) by (apply Rmult_le_pos; lra).
    assert (k/(k-j)*(t1-t0) < t1 - t0) by (apply Rle_lt_trans with (k/(k-j)*(t1-t0)); [lra|]; rewrite <- (Rmult_1_l (t1-t0)) at 2; apply Rmult_lt_compat_r; lra).
    split; [lra|]. split.
    - replace ((1 - (t0 + k/(k-j)*(t1-t0)))*p + (t0 + k/(k-j)*(t1-t0))*r) with ((1 - k/(k-j)) * k + k/(k-j) * j) by (unfold k, j; ring). field. lra.
    - assert (W : (t1-t0) * (r - p) = j - k) by (unfold k, j; ring).
      assert (r - p < 0). { apply (Rmult_lt_reg_l (t1-t0)); lra. }
      assert (0 <= (1-t0)*(p-r)) by (apply Rmult_le_pos; lra).
      assert (0 <= (1-t1)*(p-r)) by (apply Rmult_le_pos; lra). unfold j in N. lra. }
  (* >= 0 at both ends: >= 0 between *)
  assert (mid : forall f t t1, t0 <= t <= t1 -> t0 <= t1 <= 1 -> 0 <= val f t0 -> 0 <= val f t1 -> 0 <= val f t).
  { intros [p r] t t1 A B P Q. unfold val in *; simpl in *. destruct (Req_dec t0 t1) as [E|E]; [replace t with t0 by lra; exact P|].
    apply (Rmult_le_reg_l (t1-t0)); [lra|]. rewrite Rmult_0_r.
    replace ((t1-t0)*((1-t)*p+t*r)) with ((t1-t)*((1-t0)*p+t0*r) + (t-t0)*((1-t1)*p+t1*r)) by ring.
    apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra. }
  destruct IH as [N|(t1 & f & H1 & F & Zf & Nf & G)]; [intros; apply H; right; auto| |].
  - destruct (Rle_dec 0 (snd g)) as [L|L]; [left; intros f [<-|F]; auto|]. right.
    destruct (root 1) as (t & Ht & Zt & _); [lra|unfold val; lra|]. exists t, g.
    split; [lra|]. split; [left; reflexivity|]. split; [exact Zt|]. split; [lra|].
    intros f [<-|F]; [lra|]. apply (mid f t 1); [lra|lra|apply H; right; exact F|]. unfold val. specialize (N f F). lra.
  - right. destruct (Rle_dec 0 (val g t1)) as [L|L].
    + exists t1, f. split; [lra|]. split; [right; exact F|]. repeat split; try assumption. intros f' [<-|F']; auto.
    + destruct (root t1) as (t & Ht & Zt & Ng); [lra|lra|]. exists t, g. split; [lra|]. split; [left; reflexivity|]. repeat split; try assumption.
      intros f' [<-|F']; [lra|]. apply (mid f' t t1); [lra|lra|apply H; right; exact F'|apply G; exact F'].
Qed.
