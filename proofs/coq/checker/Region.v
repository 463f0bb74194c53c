(* SPDX-License-Identifier: Apache-2.0 *)
(** * Positively oriented cells whose directed edges add up to the boundary: their union is the region *)
From Coq Require Import ZArith List Bool Lia Reals Lra Psatz.
From Confidel.checker Require Import Space Statement Planar Crossing Walk.
Import ListNotations.
Open Scope R_scope.

(** sums over directed edges *)
Definition sum {A} (f : A -> Z) (l : list A) : Z := fold_right (fun e s => (f e + s)%Z) 0%Z l.
Lemma sum_app {A} (f : A -> Z) l m : sum f (l ++ m) = (sum f l + sum f m)%Z.
Proof. induction l; simpl; [reflexivity|]. rewrite IHl. lia. Qed.
Lemma sum_ext {A} (f g : A -> Z) l : (forall x, f x = g x) -> sum f l = sum g l.
Proof. intro H. induction l; simpl; [reflexivity|]. rewrite IHl, H. reflexivity. Qed.

Lemma area2_turn : forall p q r u v x, area2 (planar p q r u) (planar p q r v) (planar p q r x) = dist2 q p * turn (normal p q r) u v x.
Proof.
  intros p q r u v x. unfold planar.
  assert (E : dot (normal p q r) (minus q p) = 0) by (unfold normal, dot, cross, minus; simpl; ring).
  revert E. generalize (normal p q r). unfold dist2. generalize (minus q p). intros e n E.
  apply Rminus_diag_uniq.
  transitivity (- dot e (cross (minus v u) (minus x u)) * dot n e); [|rewrite E; ring].
  unfold area2, turn, dot, cross, minus; simpl. ring.
Qed.

Section Region.
Variables (p q r : point).
Hypothesis n0 : normal p q r <> origin.
Notation n := (normal p q r).
Notation flat := (flat_at p n).
Variables (at_ : number -> point) (cells : list triple).
Notation in_cell := (in_cell p n at_).
Hypothesis flat_cells : forall c, In c cells -> let '(i, j, k) := c in flat (at_ i) /\ flat (at_ j) /\ flat (at_ k) /\ 0 < turn n (at_ i) (at_ j) (at_ k).
Definition edge_crossing x (e : number * number) := crossing (planar p q r x) (planar p q r (at_ (fst e))) (planar p q r (at_ (snd e))).
Variable wind : point -> Z.
Hypothesis wind_cells : forall x, wind x = sum (edge_crossing x) (flat_map sides cells).

Lemma e_pos : 0 < dist2 q p.
Proof.
  destruct (Req_dec (dist2 q p) 0) as [E|E]; [exfalso|pose proof (dist2_nonneg q p); lra].
  apply n0. apply dist2_zero in E. unfold normal. rewrite E. unfold cross, minus, origin; simpl. f_equal; ring.
Qed.
Lemma sign : forall u v x, (0 < turn n u v x <-> 0 < area2 (planar p q r u) (planar p q r v) (planar p q r x)) /\
  (0 <= turn n u v x <-> 0 <= area2 (planar p q r u) (planar p q r v) (planar p q r x)).
Proof.
  intros. rewrite area2_turn. pose proof e_pos as P. set (t := turn n u v x). clearbody t. split; split; intro H.
  - apply Rmult_lt_0_compat; assumption.
  - apply (Rmult_lt_reg_l (dist2 q p)); lra.
  - apply Rmult_le_pos; lra.
  - apply (Rmult_le_reg_l (dist2 q p)); lra.
Qed.
Definition cell_crossing x (c : triple) := sum (edge_crossing x) (sides c).
Lemma cell_crossings : forall c x, In c cells -> (0 <= cell_crossing x c)%Z /\
  (flat x -> cell_crossing x c <> 0%Z -> in_cell c x) /\
  ((let '(i, j, k) := c in 0 < turn n (at_ i) (at_ j) x /\ 0 < turn n (at_ j) (at_ k) x /\ 0 < turn n (at_ k) (at_ i) x) -> cell_crossing x c = 1%Z).
Proof.
  intros [[i j] k] x H. destruct (flat_cells _ H) as (_ & _ & _ & P). apply sign in P.
  destruct (crossing_triangle (planar p q r x) _ _ _ P) as (A & B & C).
  assert (E : cell_crossing x (i, j, k) = crossing3 (planar p q r x) (planar p q r (at_ i)) (planar p q r (at_ j)) (planar p q r (at_ k))).
  { unfold cell_crossing, sides, sum, edge_crossing, crossing3; simpl. lia. }
  rewrite E. split; [exact A|split].
  - intros F N. destruct (B N) as (B1 & B2 & B3). split; [exact F|]. repeat split; apply sign; assumption.
  - intros (C1 & C2 & C3). apply C; apply sign; assumption.
Qed.
Lemma wind_sum : forall x, wind x = sum (cell_crossing x) cells.
Proof.
  intro x. rewrite wind_cells. clear. induction cells as [|c l IH]; [reflexivity|]. cbn [flat_map]. rewrite sum_app, IH. reflexivity.
Qed.

Theorem inside_region : forall c x, In c cells -> in_cell c x ->
  forall eps, 0 < eps -> exists y, dist2 x y < eps /\ flat y /\ wind y <> 0%Z.
Proof.
  intros c x Hc Ic eps He. pose proof (flat_cells c Hc) as F. pose proof (fun y => proj2 (proj2 (cell_crossings c y Hc))) as One.
  destruct c as [[i j] k]. destruct F as (Fi & Fj & Fk & P). destruct Ic as (Fx & X1 & X2 & X3).
  set (m := mix3 (at_ i) (at_ j) (at_ k) (1/3) (1/3) (1/3)).
  assert (Fm : flat m) by (apply flat_mix3; auto; lra).
  assert (M : 0 < turn n (at_ i) (at_ j) m /\ 0 < turn n (at_ j) (at_ k) m /\ 0 < turn n (at_ k) (at_ i) m).
  { unfold m. rewrite !turn_mix3 by lra. rewrite !turn_same, !turn_same', (turn_rot n (at_ j) (at_ k) (at_ i)), (turn_rot n (at_ i) (at_ j) (at_ k)). repeat split; lra. }
  destruct M as (M1 & M2 & M3).
  pose proof (dist2_nonneg x m) as Dn. assert (Q : 0 < dist2 x m + eps) by lra. assert (I := Rinv_0_lt_compat _ Q).
  set (t := eps / (dist2 x m + eps)). assert (T0 : 0 < t) by (apply Rmult_lt_0_compat; lra).
  assert (Te : t * (dist2 x m + eps) = eps) by (unfold t; field; lra).
  assert (T1 : t <= 1).
  { apply (Rmult_le_reg_r (dist2 x m + eps)); lra. }
  exists (towards x m t). split; [|split].
  - replace (dist2 x (towards x m t)) with (t * (t * dist2 x m)) by (unfold dist2, dot, minus, towards; simpl; ring).
    assert (0 <= t * dist2 x m) by (apply Rmult_le_pos; lra).
    assert (t * (t * dist2 x m) <= 1 * (t * dist2 x m)) by (apply Rmult_le_compat_r; lra).
    assert (0 < t * eps) by (apply Rmult_lt_0_compat; lra). lra.
  - apply flat_towards; assumption.
  - assert (K : cell_crossing (towards x m t) (i, j, k) = 1%Z).
    { apply One. rewrite !turn_towards.
      assert (Q2 : forall a b, 0 <= a -> 0 < b -> 0 < (1-t)*a + t*b) by (intros; apply Rplus_le_lt_0_compat; [apply Rmult_le_pos|apply Rmult_lt_0_compat]; lra).
      auto. }
    rewrite wind_sum.
    assert (G : forall l, incl l cells -> (0 <= sum (cell_crossing (towards x m t)) l)%Z /\ (In (i, j, k) l -> (1 <= sum (cell_crossing (towards x m t)) l)%Z)).
    { induction l as [|d l IH]; intro L; [simpl; split; [lia|intros []]|]. destruct IH as [I1 I2]; [intros e E; apply L; right; exact E|].
      destruct (cell_crossings d (towards x m t)) as [J _]; [apply L; left; reflexivity|]. cbn [sum fold_right]. fold (sum (cell_crossing (towards x m t)) l).
      split; [lia|]. intros [->|E]; [rewrite K; lia|specialize (I2 E); lia]. }
    destruct (G cells (incl_refl _)) as [_ G2]. specialize (G2 Hc). lia.
Qed.

Lemma away : forall x, flat x -> forall L, (exists c, In c L /\ in_cell c x) \/
  exists eps, 0 < eps /\ forall y c, flat y -> dist2 x y < eps -> In c L -> ~ in_cell c y.
Proof.
  intros x Fx. induction L as [|c L [(d & H1 & H2)|(eps & He & No)]].
  - right. exists 1. split; [lra|]. intros y c _ _ [].
  - left. exists d. split; [right; exact H1|exact H2].
  - destruct (in_cell_dec p n at_ c x Fx) as [I|(u & w & Hu & Neg)]; [left; exists c; split; [left; reflexivity|exact I]|right].
    set (g := cross n (minus (at_ w) (at_ u))).
    assert (Gp : 0 <= dot g g) by (unfold dot; pose proof (Rle_0_sqr (cx g)); pose proof (Rle_0_sqr (cy g)); pose proof (Rle_0_sqr (cz g)); unfold Rsqr in *; lra).
    set (t := turn n (at_ u) (at_ w) x) in *. assert (Q : 0 < dot g g + 1) by lra. assert (Iq := Rinv_0_lt_compat _ Q).
    assert (Tp : 0 < t * t) by (pose proof (Rsqr_pos_lt t); unfold Rsqr in *; lra).
    set (e := t * t / (dot g g + 1)). assert (Ep : 0 < e) by (apply Rmult_lt_0_compat; assumption).
    assert (Ee : (dot g g + 1) * e = t * t) by (unfold e; field; lra).
    exists (Rmin eps e). split; [apply Rmin_pos; assumption|]. intros y d Fy Dy [<-|Hd].
    + intro Iy. assert (Y : 0 <= turn n (at_ u) (at_ w) y).
      { destruct c as [[i j] k]. destruct Iy as (_ & Y1 & Y2 & Y3). unfold sides in Hu. cbn [In] in Hu.
        destruct Hu as [Hu|[Hu|[Hu|[]]]]; injection Hu; intros; subst u w; assumption. }
      assert (E : turn n (at_ u) (at_ w) y = t + dot g (minus y x)) by (unfold t, g, turn, dot, cross, minus; simpl; ring).
      assert (CS : dot g (minus y x) * dot g (minus y x) <= dot g g * dist2 x y).
      { unfold dist2. set (s := minus x y). assert (S : minus y x = Point (- cx s) (- cy s) (- cz s)) by (unfold s, minus; simpl; f_equal; ring).
        rewrite S. clearbody s. clear. destruct g as [g1 g2 g3], s as [s1 s2 s3]. unfold dot; simpl.
        pose proof (Rle_0_sqr (g1*s2-g2*s1)). pose proof (Rle_0_sqr (g2*s3-g3*s2)). pose proof (Rle_0_sqr (g3*s1-g1*s3)). unfold Rsqr in *. lra. }
      assert (De : dist2 x y < e) by (eapply Rlt_le_trans; [exact Dy|apply Rmin_r]). pose proof (dist2_nonneg x y).
      assert (B : dot g g * dist2 x y <= (dot g g + 1) * dist2 x y) by lra.
      assert (C : (dot g g + 1) * dist2 x y < (dot g g + 1) * e) by (apply Rmult_lt_compat_l; assumption).
      set (s := dot g (minus y x)) in *. rewrite E in Y. clearbody s t.
      assert (0 <= (s + t) * (s - t)) by (apply Rmult_le_pos; lra). lra.
    + apply No; auto. eapply Rlt_le_trans; [exact Dy|apply Rmin_l].
Qed.
Theorem region_inside : forall x, flat x -> (forall eps, 0 < eps -> exists y, dist2 x y < eps /\ flat y /\ wind y <> 0%Z) ->
  exists c, In c cells /\ in_cell c x.
Proof.
  intros x Fx R. destruct (away x Fx cells) as [H|(eps & He & No)]; [exact H|exfalso].
  destruct (R eps He) as (y & Dy & Fy & W). apply W. rewrite wind_sum.
  assert (G : forall l, incl l cells -> sum (cell_crossing y) l = 0%Z).
  { induction l as [|d l IH]; intro L; [reflexivity|]. cbn [sum fold_right]. fold (sum (cell_crossing y) l). rewrite IH by (intros e E; apply L; right; exact E).
    destruct (Z.eq_dec (cell_crossing y d) 0) as [Z|Z]; [lia|exfalso]. assert (Hd : In d cells) by (apply L; left; reflexivity).
    apply (No y d Fy Dy Hd). apply (cell_crossings d y Hd); assumption. }
  apply G, incl_refl.
Qed.
End Region.
