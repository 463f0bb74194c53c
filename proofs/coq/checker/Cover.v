(* SPDX-License-Identifier: Apache-2.0 *)
(** * Every point of a cell lies in a triangle of the subdivision whose corners are on the cell's sphere

    [Support.support] gives a face; it may be an edge or a vertex. Near every point of the cell there are points off all lines through two
    points of V: their faces are triangles. There are finitely many triangles, and they are closed. *)
From Coq Require Import Arith List Bool Lia Reals Lra Psatz.
From Confidel.checker Require Import Space Statement Planar Support.
Import ListNotations.
Open Scope R_scope.

Section Cover.
Variables (o n : point).
Hypothesis n0 : n <> origin.
Variables (V : list point) (T : list simplex).
Hypothesis D : covering V T.
Notation flat_at := (flat_at o n).
Notation turn := (turn n).
Notation within := (within o n).
Variables (z a b c : point).
Hypotheses (Fa : flat_at a) (Fb : flat_at b) (Fc : flat_at c) (Va : In a V) (Vb : In b V) (Vc : In c V).
Hypothesis abc : 0 < turn a b c.
Hypotheses (zb : dist2 z b = dist2 z a) (zc : dist2 z c = dist2 z a).
Hypothesis empty : forall v, In v V -> dist2 z a <= dist2 z v /\ (dist2 z v = dist2 z a -> flat_at v).
Definition on v := dist2 z v = dist2 z a.
Definition strictly m := flat_at m /\ 0 < turn a b m /\ 0 < turn b c m /\ 0 < turn c a m.

Lemma generic : forall L : list (point * point), exists m, strictly m /\
  forall u w, In (u, w) L -> u <> w -> flat_at u -> flat_at w -> turn u w m <> 0.
Proof.
  induction L as [|[u w] L (m & (Fm & M1 & M2 & M3) & G)].
  - exists (mix3 a b c (1/3) (1/3) (1/3)). split; [|intros ? ? []]. split; [apply flat_mix3; auto; lra|].
    rewrite !turn_mix3 by lra. rewrite !turn_same, !turn_same', (turn_rot n b c a), (turn_rot n a b c). repeat split; lra.
  - destruct (point_eq_dec u w) as [E|N]; [exists m; split; [split; auto|]; intros u' w' [H|H]; [injection H; intros; subst; contradiction|auto]|].
    destruct (Req_dec (turn u w m) 0) as [Z|Z].
    2:{ exists m; split; [split; auto|]. intros u' w' [H|H]; [injection H; intros; subst; exact Z|auto]. }
    assert (dflat : flat_at u /\ flat_at w \/ ~ (flat_at u /\ flat_at w)).
    { unfold Planar.flat_at. destruct (Req_dec (dot n (minus u o)) 0), (Req_dec (dot n (minus w o)) 0); tauto. }
    destruct dflat as [[Fu Fw]|NF]; [|exists m; split; [split; auto|]; intros u' w' [H|H]; [injection H; intros; subst; tauto|auto]].
    assert (C : exists p, (p = a \/ p = b \/ p = c) /\ turn u w p <> 0).
    { destruct (turn_some_corner o n n0 u w a b c N Fu Fw Fa Fb Fc) as [K|[K|K]]; [lra| | |]; eauto 6. }
    destruct C as (p & Hp & Np).
    assert (P : flat_at p /\ 0 <= turn a b p /\ 0 <= turn b c p /\ 0 <= turn c a p).
    { destruct Hp as [->|[->| ->]]; rewrite ?turn_same, ?turn_same'; repeat split; try assumption; try lra.
      - rewrite turn_rot. lra. - rewrite turn_rot, turn_rot. lra. }
    destruct P as (Fp & P1 & P2 & P3).
    destruct (small_nonzero (map (fun e => if Req_EM_T (turn (fst e) (snd e) m) 0 then (1, 1) else (turn (fst e) (snd e) m, turn (fst e) (snd e) p)) L)) as (e & He & Ge).
    { intros f H. apply in_map_iff in H. destruct H as ([u' w'] & <- & H). cbn [fst snd]. destruct (Req_EM_T (turn u' w' m) 0); simpl; lra. }
    exists (towards m p e). split.
    + split; [apply flat_towards; auto|]. rewrite !turn_towards.
      assert (Q : forall s t, 0 < s -> 0 <= t -> 0 < (1-e)*s + e*t).
      { intros s t Hs Ht. apply Rplus_lt_le_0_compat; [apply Rmult_lt_0_compat; lra|apply Rmult_le_pos; lra]. }
      auto.
    + intros u' w' [H|H] N' Fu' Fw'.
      * injection H; intros; subst u' w'. rewrite turn_towards, Z. intro K. apply Np. apply (Rmult_eq_reg_l e); lra.
      * rewrite turn_towards. specialize (G u' w' H N' Fu' Fw').
        specialize (Ge e _ ltac:(lra) (in_map _ _ _ H)). cbn [fst snd] in Ge. destruct (Req_EM_T (turn u' w' m) 0); [contradiction|]. exact Ge.
Qed.

(** ** A point y of the cell off all lines *)
Section Generic.
Variable y : point.
Hypothesis y_off : forall u w, In u V -> In w V -> u <> w -> flat_at u -> flat_at w -> turn u w y <> 0.
Lemma not_vertex : forall v, In v V -> flat_at v -> y <> v.
Proof.
  intros v Hv Fv E. assert (N : a <> b) by (intro K; pose proof abc as Q; rewrite K, turn_refl in Q; lra).
  destruct (point_eq_dec v a) as [->|Na].
  - apply (y_off a b); auto. rewrite E, turn_same. reflexivity.
  - apply (y_off v a); auto. rewrite E, turn_same. reflexivity.
Qed.
Lemma not_edge : forall u v w l m, In u V -> In v V -> l + m = 1 -> (l = 0 \/ on u) -> (m = 0 \/ on v) -> y = mix3 u v w l m 0 -> False.
Proof.
  intros u v w l m Hu Hv S [Zl|Ou] [Zm|Ov] E; try lra.
  - assert (m = 1) by lra. subst l m. apply (not_vertex v Hv); [apply (empty v Hv); exact Ov|]. rewrite E. destruct v; unfold mix3; simpl; f_equal; ring.
  - assert (l = 1) by lra. subst l m. apply (not_vertex u Hu); [apply (empty u Hu); exact Ou|]. rewrite E. destruct u; unfold mix3; simpl; f_equal; ring.
  - destruct (point_eq_dec u v) as [->|N].
    + apply (not_vertex v Hv); [apply (empty v Hv); exact Ov|]. rewrite E. assert (l = 1 - m) by lra. subst l. destruct v; unfold mix3; simpl; f_equal; ring.
    + apply (y_off u v); auto; [apply (empty u Hu); exact Ou|apply (empty v Hv); exact Ov|].
      rewrite E, turn_mix3 by lra. rewrite turn_same, turn_same'. ring.
Qed.
Lemma mix3_rot : forall u v w l m k, mix3 u v w l m k = mix3 v w u m k l.
Proof. intros. unfold mix3. f_equal; ring. Qed.
Lemma mix3_swap : forall u v w l m k, mix3 u v w l m k = mix3 v u w m l k.
Proof. intros. unfold mix3. f_equal; ring. Qed.
Lemma real_triangle : forall u v w l m k, In u V -> In v V -> In w V -> l + m + k = 1 ->
  (l = 0 \/ on u) -> (m = 0 \/ on v) -> (k = 0 \/ on w) -> y = mix3 u v w l m k -> on u /\ on v /\ on w /\ turn u v w <> 0.
Proof.
  intros u v w l m k Hu Hv Hw S Cu Cv Cw E.
  destruct (Req_dec l 0) as [Z|Nl]; [exfalso; subst l; apply (not_edge v w u m k); auto; [lra|rewrite E; apply mix3_rot]|].
  destruct (Req_dec m 0) as [Z|Nm]; [exfalso; subst m; apply (not_edge w u v k l); auto; [lra|rewrite E, mix3_rot, mix3_rot; reflexivity]|].
  destruct (Req_dec k 0) as [Z|Nk]; [exfalso; subst k; apply (not_edge u v w l m); auto; lra|].
  destruct Cu as [|Ou]; [lra|]. destruct Cv as [|Ov]; [lra|]. destruct Cw as [|Ow]; [lra|]. repeat split; auto.
  intro K. destruct (point_eq_dec u v) as [->|N].
  - apply (not_edge v w v (l+m) k); auto. rewrite E. unfold mix3. f_equal; ring.
  - apply (y_off u v); auto; [apply (empty u Hu); exact Ou|apply (empty v Hv); exact Ov|].
    rewrite E, turn_mix3 by exact S. rewrite turn_same, turn_same', K. ring.
Qed.
Definition triples (t : simplex) : list (point * point * point) := let '(p, q, r, s) := t in
  [(p,q,r); (p,q,s); (p,r,s); (q,r,s); (q,p,r); (q,p,s); (r,p,s); (r,q,s)].
Definition ok (f : point * point * point) := let '(u, v, w) := f in on u /\ on v /\ on w /\ 0 < turn u v w.
Definition has_point (f : point * point * point) x := let '(u, v, w) := f in in_triangle u v w x.
Lemma coplanar : forall p q r s, flat_at p -> flat_at q -> flat_at r -> flat_at s -> dot (normal p q r) (minus s p) = 0.
Proof.
  intros p q r s P Q R S.
  assert (Q' : dot n (minus q p) = 0) by (unfold Planar.flat_at, dot, minus in *; simpl in *; lra).
  assert (R' : dot n (minus r p) = 0) by (unfold Planar.flat_at, dot, minus in *; simpl in *; lra).
  assert (S' : dot n (minus s p) = 0) by (unfold Planar.flat_at, dot, minus in *; simpl in *; lra).
  assert (N : 0 < dot n n) by (apply dot_self_pos; exact n0). unfold normal.
  assert (E : dot n n * dot (cross (minus q p) (minus r p)) (minus s p) = 0).
  { transitivity (dot n (minus q p) * dot n (cross (minus r p) (minus s p)) + dot n (minus r p) * dot n (cross (minus s p) (minus q p)) + dot n (minus s p) * dot n (cross (minus q p) (minus r p))).
    - unfold dot, cross, minus; simpl. ring. - rewrite Q', R', S'. ring. }
  apply Rmult_integral in E. lra.
Qed.
Lemma pick : forall t u v w l m k, In t T -> In (u,v,w) (triples t) -> In (v,u,w) (triples t) -> 0 <= l -> 0 <= m -> 0 <= k -> l + m + k = 1 ->
  (l = 0 \/ on u) -> (m = 0 \/ on v) -> (k = 0 \/ on w) -> y = mix3 u v w l m k -> In u V -> In v V -> In w V ->
  exists f, In f (triples t) /\ ok f /\ has_point f y.
Proof.
  intros t u v w l m k Ht I1 I2 Hl Hm Hk S Cu Cv Cw E Hu Hv Hw.
  destruct (real_triangle u v w l m k Hu Hv Hw S Cu Cv Cw E) as (Ou & Ov & Ow & N).
  destruct (Rle_dec 0 (turn u v w)) as [L|L].
  - exists (u,v,w). repeat split; auto; [lra|]. exists l, m, k. auto.
  - exists (v,u,w). repeat split; auto; [rewrite turn_swap; lra|]. exists m, l, k. repeat split; auto; [lra|]. rewrite E. apply mix3_swap.
Qed.
Lemma face_at : within a b c y -> exists t f, In t T /\ In f (triples t) /\ ok f /\ has_point f y.
Proof.
  intro W. apply within_triangle in W; auto.
  destruct (support V T D z a b c Va Vb Vc zb zc (fun v Hv => proj1 (empty v Hv)) y W) as (t & Ht & F).
  pose proof (fun v => cov_corners _ _ D t v Ht) as Cn. pose proof (cov_proper _ _ D t Ht) as Pr. exists t.
  destruct t as [[[p q] r] s]. cbn [corner] in Cn. destruct F as (l1 & l2 & l3 & l4 & L1 & L2 & L3 & L4 & LS & Ex & F1 & F2 & F3 & F4).
  fold (on p) in F1. fold (on q) in F2. fold (on r) in F3. fold (on s) in F4.
  assert (Hp : In p V) by auto. assert (Hq : In q V) by auto. assert (Hr : In r V) by auto. assert (Hs : In s V) by auto.
  cut (exists f, In f (triples (p,q,r,s)) /\ ok f /\ has_point f y); [intros (f & K); exists f; split; tauto|].
  destruct Pr as [So|[Er _]].
  - unfold solid in So.
    destruct F1 as [Z|O1]; [subst l1; apply (pick _ q r s l2 l3 l4); auto; [simpl; auto 10|simpl; auto 10|lra|rewrite Ex; unfold mix4, mix3; f_equal; ring]|].
    destruct F2 as [Z|O2]; [subst l2; apply (pick _ p r s l1 l3 l4); auto; [simpl; auto 10|simpl; auto 10|lra|rewrite Ex; unfold mix4, mix3; f_equal; ring]|].
    destruct F3 as [Z|O3]; [subst l3; apply (pick _ p q s l1 l2 l4); auto; [simpl; auto 10|simpl; auto 10|lra|rewrite Ex; unfold mix4, mix3; f_equal; ring]|].
    destruct F4 as [Z|O4]; [subst l4; apply (pick _ p q r l1 l2 l3); auto; [simpl; auto 10|simpl; auto 10|lra|rewrite Ex; unfold mix4, mix3; f_equal; ring]|].
    exfalso. apply So. apply coplanar; [apply (empty p Hp)|apply (empty q Hq)|apply (empty r Hr)|apply (empty s Hs)]; assumption.
  - subst s. apply (pick _ p q r l1 l2 (l3+l4)); auto; [simpl; auto 10|simpl; auto 10|lra|lra| |rewrite Ex; unfold mix4, mix3; f_equal; ring].
    destruct F3 as [Z3|]; [|auto]. destruct F4 as [Z4|]; [left; lra|auto].
Qed.
End Generic.

(** ** All points of the cell *)
Lemma limit : forall (x m : point) e (L : list (point * point * point)), flat_at x -> flat_at m -> 0 < e ->
  (forall t, 0 < t <= e -> exists f, In f L /\ ok f /\ has_point f (towards x m t)) ->
  (forall u v w, In (u,v,w) L -> In u V /\ In v V /\ In w V) ->
  exists f, In f L /\ ok f /\ has_point f x.
Proof.
  intros x m e L Fx Fm. revert e. induction L as [|[[u v] w] L IH]; intros e He H HV.
  - destruct (H e) as (f & [] & _). lra.
  - destruct (HV u v w) as (Hu & Hv & Hw); [left; reflexivity|].
    assert (dec : ok (u,v,w) \/ ~ ok (u,v,w)).
    { unfold ok, on. destruct (Req_dec (dist2 z u) (dist2 z a)), (Req_dec (dist2 z v) (dist2 z a)), (Req_dec (dist2 z w) (dist2 z a));
      destruct (Rlt_dec 0 (turn u v w)); tauto. }
    assert (next : (exists e', 0 < e' /\ forall t, 0 < t <= e' -> ~ (ok (u,v,w) /\ has_point (u,v,w) (towards x m t))) ->
      exists f, In f ((u,v,w) :: L) /\ ok f /\ has_point f x).
    { intros (e' & He' & No). destruct (IH (Rmin e e')) as (f & F1 & F2).
      - apply Rmin_pos; assumption.
      - intros t [T0 T1]. destruct (H t) as (f & F1 & F2 & F3); [split; [exact T0|eapply Rle_trans; [exact T1|apply Rmin_l]]|].
        destruct F1 as [F1|F1]; [|eauto]. exfalso. subst f. apply (No t); auto. split; [exact T0|eapply Rle_trans; [exact T1|apply Rmin_r]].
      - intros; apply HV; right; assumption.
      - exists f. split; [right; exact F1|exact F2]. }
    destruct dec as [K|K].
    2:{ apply next. exists 1. split; [lra|]. intros t _ [K' _]. contradiction. }
    pose proof K as (O1 & O2 & O3 & P).
    assert (Fu : flat_at u) by (apply (empty u Hu); exact O1). assert (Fv : flat_at v) by (apply (empty v Hv); exact O2). assert (Fw : flat_at w) by (apply (empty w Hw); exact O3).
    assert (out : forall p q, turn p q x < 0 -> (forall t, within u v w (towards x m t) -> 0 <= turn p q (towards x m t)) ->
      exists f, In f ((u,v,w) :: L) /\ ok f /\ has_point f x).
    { intros p q Nx Wi. apply next.
      destruct (small_positive [(- turn p q x, - turn p q m)]) as (e' & He' & G); [intros f [<-|[]]; simpl; lra|].
      exists e'. split; [lra|]. intros t Ht [_ I]. apply triangle_within with (o := o) (n := n) in I; auto; [|lra].
      specialize (Wi t I). specialize (G t _ ltac:(lra) (or_introl eq_refl)). rewrite turn_towards in Wi. unfold val in G; cbn [fst snd] in G. lra. }
    destruct (Rle_dec 0 (turn u v x)) as [L1|L1]; [|apply (out u v); [lra|intros t W; apply W]].
    destruct (Rle_dec 0 (turn v w x)) as [L2|L2]; [|apply (out v w); [lra|intros t W; apply W]].
    destruct (Rle_dec 0 (turn w u x)) as [L3|L3]; [|apply (out w u); [lra|intros t W; apply W]].
    exists (u,v,w). split; [left; reflexivity|]. split; [exact K|]. apply within_triangle with (o := o) (n := n); auto. unfold Planar.within. auto.
Qed.

Theorem cell_covered : forall x, within a b c x -> exists u v w, face_of T u v w /\ in_triangle u v w x /\
  In u V /\ In v V /\ In w V /\ dist2 z u = dist2 z a /\ dist2 z v = dist2 z a /\ dist2 z w = dist2 z a.
Proof.
  intros x (Fx & X1 & X2 & X3).
  destruct (generic (list_prod V V)) as (m & (Fm & M1 & M2 & M3) & G).
  destruct (small_nonzero (map (fun e => if Req_EM_T (turn (fst e) (snd e) x) 0 then (1, 1) else (turn (fst e) (snd e) x, turn (fst e) (snd e) m)) (list_prod V V))) as (e & He & Ge).
  { intros f H. apply in_map_iff in H. destruct H as ([u w] & <- & _). cbn [fst snd]. destruct (Req_EM_T (turn u w x) 0); simpl; lra. }
  assert (tri : forall t f, In t T -> In f (triples t) -> let '(u,v,w) := f in corner t u /\ corner t v /\ corner t w).
  { intros [[[p q] r] s] f _ H. unfold triples in H. cbn [In] in H. unfold corner. repeat (destruct H as [<-|H]; [tauto|]). destruct H. }
  destruct (limit x m e (flat_map triples T)) as (f & F1 & F2 & F3); auto; [lra| | |].
  - intros t Ht. destruct (face_at (towards x m t)) as (s & f & Hs & Hf & K).
    + intros u w Hu Hw N Fu Fw. rewrite turn_towards. assert (I : In (u,w) (list_prod V V)) by (apply in_prod; assumption).
      specialize (G u w I N Fu Fw). specialize (Ge t _ ltac:(lra) (in_map _ _ _ I)). cbn [fst snd] in Ge.
      destruct (Req_EM_T (turn u w x) 0) as [Z|Z]; [rewrite Z|exact Ge]. intro K. apply G. apply (Rmult_eq_reg_l t); lra.
    + split; [apply flat_towards; auto|]. rewrite !turn_towards.
      assert (Q : forall r s, 0 <= r -> 0 < s -> 0 <= (1-t)*r + t*s) by (intros r s Hr Hs; apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra).
      auto.
    + exists f. split; [apply in_flat_map; eauto|exact K].
  - intros u v w H. apply in_flat_map in H. destruct H as (t & Ht & H). destruct (tri t _ Ht H) as (C1 & C2 & C3).
    repeat split; eapply cov_corners; eauto.
  - apply in_flat_map in F1. destruct F1 as (t & Ht & Hf). destruct f as [[u v] w]. destruct (tri t _ Ht Hf) as (C1 & C2 & C3).
    destruct F2 as (O1 & O2 & O3 & P). exists u, v, w. split; [|split; [exact F3|]].
    + split; [|eauto]. unfold collinear. intro K. unfold Planar.turn in P. rewrite K in P. unfold dot, origin in P; simpl in P. lra.
    + repeat split; auto; eapply cov_corners; eauto.
Qed.
End Cover.
