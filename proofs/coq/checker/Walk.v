(* SPDX-License-Identifier: Apache-2.0 *)
(** * The polygon of a cell stays in its facet

    Let S be a cell's sphere. The points of V on S span a polygon in the facet's plane, and every Delaunay subdivision covers it by its own faces.
    Here: that polygon lies in the union of the facet's cells. Walk from the cell straight to a point x of the polygon; where the walk leaves a
    cell through an edge, some point of V on S is beyond that edge. So the edge is not constrained (rule tie), and there is a cell behind it
    (rule tiling); by emptiness that cell has the same circle. All corners are on the circle, and the walk stays inside it: it never meets a corner.
    It never returns to a cell, so it ends: in a cell that contains x. *)
From Coq Require Import ZArith Arith List Bool Lia Reals Lra Psatz.
From Confidel.checker Require Import Space Statement Planar Support.
Import ListNotations.
Open Scope R_scope.

Definition triple := (number * number * number)%type.
Lemma triple_dec : forall c d : triple, {c = d} + {c <> d}.
Proof. repeat decide equality. Qed.
Definition sides (c : triple) : list (number * number) := let '(i, j, k) := c in [(i, j); (j, k); (k, i)].

Section Walk.
Variables (o n : point).
Hypothesis n0 : n <> origin.
Variables (V : list point) (at_ : number -> point) (cells : list triple) (fixed : number -> number -> Prop).
Notation flat_at := (flat_at o n).
Notation turn := (turn n).
Notation within := (within o n).

(** What the check establishes for a cell: [z] is its sphere's centre. *)
Record good (c : triple) (z : point) : Prop := {
  good_flat : let '(i, j, k) := c in flat_at (at_ i) /\ flat_at (at_ j) /\ flat_at (at_ k);
  good_in : let '(i, j, k) := c in In (at_ i) V /\ In (at_ j) V /\ In (at_ k) V;
  good_turn : let '(i, j, k) := c in 0 < turn (at_ i) (at_ j) (at_ k);
  good_through : let '(i, j, k) := c in dist2 z (at_ j) = dist2 z (at_ i) /\ dist2 z (at_ k) = dist2 z (at_ i);
  good_empty : forall v, In v V -> let '(i, j, k) := c in dist2 z (at_ i) <= dist2 z v /\ (dist2 z v = dist2 z (at_ i) -> flat_at v);
  good_tie : forall v u w, In v V -> In (u, w) (sides c) -> fixed u w -> dist2 z v = dist2 z (at_ u) -> 0 <= turn (at_ u) (at_ w) v }.
Hypothesis all_good : forall c, In c cells -> exists z, good c z.
Hypothesis paired : forall c u w, In c cells -> In (u, w) (sides c) -> fixed u w \/ exists c', In c' cells /\ In (w, u) (sides c').

Definition in_cell (c : triple) x := let '(i, j, k) := c in within (at_ i) (at_ j) (at_ k) x.

(** a cell seen from one of its edges u w *)
Record seen (c : triple) z u w d : Prop := {
  seen_flat : flat_at (at_ u) /\ flat_at (at_ w) /\ flat_at (at_ d);
  seen_in : In (at_ u) V /\ In (at_ w) V /\ In (at_ d) V;
  seen_turn : 0 < turn (at_ u) (at_ w) (at_ d);
  seen_through : dist2 z (at_ w) = dist2 z (at_ u) /\ dist2 z (at_ d) = dist2 z (at_ u);
  seen_empty : forall v, In v V -> dist2 z (at_ u) <= dist2 z v /\ (dist2 z v = dist2 z (at_ u) -> flat_at v);
  seen_cell : forall x, in_cell c x <-> within (at_ u) (at_ w) (at_ d) x }.
Lemma see : forall c z u w, good c z -> In (u, w) (sides c) -> exists d, seen c z u w d.
Proof.
  intros [[i j] k] z u w [A B C D E F] H. unfold sides in H. cbn [In] in H.
  destruct D as [D1 D2].
  destruct H as [H|[H|[H|[]]]]; injection H; intros; subst u w; clear H; [exists k|exists i|exists j];
  (split; [tauto|tauto|first [exact C | rewrite turn_rot; exact C | rewrite turn_rot, turn_rot; exact C]
          |split; lra
          |intros v Hv; destruct (E v Hv) as [E1 E2]; split; [lra|intro; apply E2; lra]
          |intro; unfold in_cell, Planar.within; tauto]).
Qed.

(** Two cells on both sides of an edge, and a point of the first one's circle beyond the edge: the circles are the same. *)
Lemma same_circle : forall c z u w d c' z' d' q, seen c z u w d -> seen c' z' w u d' -> In q V ->
  dist2 z q = dist2 z (at_ u) -> turn (at_ u) (at_ w) q < 0 -> forall x, flat_at x -> pow z' (at_ u) x = pow z (at_ u) x.
Proof.
  intros c z u w d c' z' d' q [F1 I1 T1 H1 E1 _] [F2 I2 T2 H2 E2 _] Q Ez Tq.
  set (L := fun x => pow z (at_ u) x - pow z' (at_ u) x).
  assert (aff : forall x, flat_at x -> turn (at_ u) (at_ w) (at_ d') * L x = turn (at_ u) (at_ w) x * L (at_ d')).
  { intros x X. destruct (bary o n n0 (at_ u) (at_ w) (at_ d') x) as (X1 & X2 & X3); try tauto.
    pose proof (turn_sum n (at_ u) (at_ w) (at_ d') x) as S.
    assert (lin : forall y, L y = dot (minus z' z) (minus y (at_ u)) + dot (minus z' z) (minus y (at_ u))).
    { intro y. unfold L, pow, dist2, dot, minus; simpl. ring. }
    assert (Lw : dot (minus z' z) (minus (at_ w) (at_ u)) = 0).
    { assert (L (at_ w) = 0) by (unfold L, pow; destruct H1, H2; lra). rewrite lin in H. lra. }
    rewrite !lin. clear lin. revert X1 X2 X3 S Lw.
    generalize (turn (at_ u) (at_ w) (at_ d')) (turn (at_ w) (at_ d') x) (turn (at_ d') (at_ u) x) (turn (at_ u) (at_ w) x).
    generalize (minus z' z) (at_ u) (at_ w) (at_ d'). clear. intros g a b e d t1 t2 t3 X1 X2 X3 S Lw.
    assert (G : d * dot g (minus x a) = t3 * dot g (minus e a)).
    { transitivity (t2 * dot g (minus b a) + t3 * dot g (minus e a)); [|rewrite Lw; ring].
      unfold dot, minus; simpl.
      transitivity (cx g * (d * cx x) + cy g * (d * cy x) + cz g * (d * cz x) - d * (cx g * cx a + cy g * cy a + cz g * cz a)); [ring|].
      rewrite X1, X2, X3, <- S. ring. }
    lra. }
  assert (Td : turn (at_ u) (at_ w) (at_ d') < 0) by (rewrite turn_swap; lra).
  assert (Ld : 0 <= L (at_ d')).
  { unfold L, pow. destruct (E1 (at_ d')) as [K _]; [tauto|]. destruct H2 as [J1 J2]. lra. }
  assert (Fq : flat_at q) by (apply (E1 q Q); exact Ez).
  assert (Lq : L q <= 0).
  { unfold L, pow. destruct (E2 q Q) as [K _]. destruct H2 as [J1 J2]. lra. }
  pose proof (aff q Fq) as Aq.
  assert (Z : L (at_ d') = 0).
  { assert (0 <= turn (at_ u) (at_ w) (at_ d') * L q) by (replace (turn (at_ u) (at_ w) (at_ d') * L q) with ((- turn (at_ u) (at_ w) (at_ d')) * (- L q)) by ring; apply Rmult_le_pos; lra).
    destruct (Req_dec (L (at_ d')) 0) as [|N]; [assumption|exfalso].
    assert (0 < (- turn (at_ u) (at_ w) q) * L (at_ d')) by (apply Rmult_lt_0_compat; lra). lra. }
  intros x X. pose proof (aff x X) as Ax. rewrite Z, Rmult_0_r in Ax. apply Rmult_integral in Ax. unfold L in Ax. lra.
Qed.

Lemma beyond_dec : forall (P f : point -> R) (l : list point),
  (forall q, In q l -> P q = 0 -> 0 <= f q) \/ exists q, In q l /\ P q = 0 /\ f q < 0.
Proof.
  intros P f. induction l as [|p l [IH|(q & H1 & H2)]]; [left; intros ? []| |right; exists q; simpl; auto].
  destruct (Req_dec (P p) 0) as [E|E]; [destruct (Rle_dec 0 (f p)) as [L|L]|].
  - left. intros q [<-|H] K; auto.
  - right. exists p. simpl. repeat split; auto. lra.
  - left. intros q [<-|H] K; [contradiction|auto].
Qed.
Lemma in_cell_dec : forall c x, flat_at x -> in_cell c x \/ exists u w, In (u, w) (sides c) /\ turn (at_ u) (at_ w) x < 0.
Proof.
  intros [[i j] k] x X. unfold in_cell, Planar.within, sides.
  destruct (Rle_dec 0 (turn (at_ i) (at_ j) x)); [|right; exists i, j; simpl; split; [auto|lra]].
  destruct (Rle_dec 0 (turn (at_ j) (at_ k) x)); [|right; exists j, k; simpl; split; [auto|lra]].
  destruct (Rle_dec 0 (turn (at_ k) (at_ i) x)); [|right; exists k, i; simpl; split; [auto|lra]]. left; auto.
Qed.

(** ** The walk from y (inside the circle z0, a0) to x *)
Section From.
Variables (z0 a0 x y : point).
Hypothesis x_flat : flat_at x.
Hypothesis y_flat : flat_at y.
Hypothesis y_inside : pow z0 a0 y < 0.
Hypothesis circle_flat : forall q, In q V -> pow z0 a0 q = 0 -> flat_at q.
Hypothesis x_inside : pow z0 a0 x <= 0.
(** x is in the hull of the points of V on the circle, as far as lines through two points can tell *)
Hypothesis x_polygon : forall u w, (forall q, In q V -> pow z0 a0 q = 0 -> 0 <= turn u w q) -> 0 <= turn u w x.
Definition same c := exists z, good c z /\ forall u w p, In (u, w) (sides c) -> flat_at p -> pow z (at_ u) p = pow z0 a0 p.
Definition step t := towards y x t.
Definition fn u w : R * R := (turn (at_ u) (at_ w) y, turn (at_ u) (at_ w) x).
Lemma fn_val : forall u w t, val (fn u w) t = turn (at_ u) (at_ w) (step t).
Proof. intros. unfold val, fn, step. rewrite turn_towards. reflexivity. Qed.
Lemma step_flat : forall t, flat_at (step t).
Proof. intro. apply flat_towards; assumption. Qed.
Lemma step_inside : forall t, 0 <= t < 1 -> pow z0 a0 (step t) < 0.
Proof.
  intros t H. unfold step. rewrite pow_towards. pose proof (dist2_nonneg y x).
  assert (0 <= t * (1-t) * dist2 y x) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|assumption]).
  assert (0 < (1-t) * (- pow z0 a0 y)) by (apply Rmult_lt_0_compat; lra).
  assert (0 <= t * (- pow z0 a0 x)) by (apply Rmult_le_pos; lra). lra.
Qed.

(** One step: leave the cell, enter the next one. *)
Lemma leave : forall c t, In c cells -> same c -> 0 <= t < 1 -> in_cell c (step t) -> in_cell c x \/
  exists c' t', In c' cells /\ same c' /\ t < t' < 1 /\ in_cell c' (step t') /\ forall s, t' <= s < 1 -> ~ in_cell c (step s).
Proof.
  intros c t Hc (z & Gz & Sz) Ht It.
  destruct (first_exit (map (fun e => fn (fst e) (snd e)) (sides c)) t Ht) as [N|(t1 & f & Ht1 & Hf & Zf & Nf & Gf)].
  - intros f Hf. apply in_map_iff in Hf. destruct Hf as ([u w] & <- & Hu). rewrite fn_val.
    destruct (see c z u w Gz Hu) as [d Sd]. apply (seen_cell _ _ _ _ _ Sd) in It. apply It.
  - left. destruct (in_cell_dec c x x_flat) as [I|(u & w & Hu & L)]; [exact I|exfalso].
    specialize (N _ (in_map (fun e => fn (fst e) (snd e)) _ _ Hu)). simpl in N. lra.
  - right. apply in_map_iff in Hf. destruct Hf as ([u w] & <- & Hu). cbn [fst snd] in *. rewrite fn_val in Zf. unfold fn in Nf; cbn [snd] in Nf.
    destruct (see c z u w Gz Hu) as [d Sd]. pose proof Sd as [F1 I1 T1 H1 E1 C1].
    (* a point of the circle beyond u w *)
    destruct (beyond_dec (pow z0 a0) (turn (at_ u) (at_ w)) V) as [A|(q & Q1 & Q2 & Q3)].
    { exfalso. specialize (x_polygon (at_ u) (at_ w) A). lra. }
    assert (Fq : flat_at q) by (apply circle_flat; assumption).
    assert (Ez : dist2 z q = dist2 z (at_ u)) by (pose proof (Sz u w q Hu Fq) as K; unfold pow in *; lra).
    destruct (paired c u w Hc Hu) as [X|(c' & Hc' & Hu')].
    { exfalso. pose proof (good_tie _ _ Gz q u w Q1 Hu X Ez). lra. }
    destruct (all_good c' Hc') as [z' Gz']. destruct (see c' z' w u Gz' Hu') as [d' Sd'].
    pose proof (same_circle c z u w d c' z' d' q Sd Sd' Q1 Ez Q3) as SC. pose proof Sd' as [F2 I2 T2 H2 E2 C2].
    destruct H1 as [H1 H1'], H2 as [H2 H2'].
    assert (same c') as Sc'.
    { exists z'. split; [exact Gz'|]. intros u' w' p Hp Fp. rewrite <- (Sz u w p Hu Fp), <- (SC p Fp).
      unfold pow. pose proof (good_through _ _ Gz') as G. clear - Hp Hu' G. destruct c' as [[i j] k]. unfold sides in *. cbn [In] in *.
      destruct G as [G1 G2].
      destruct Hp as [Hp|[Hp|[Hp|[]]]]; injection Hp; intros; subst u' w'; destruct Hu' as [Hu'|[Hu'|[Hu'|[]]]]; injection Hu'; intros; subst u w; lra. }
    (* the place of exit *)
    set (p := step t1) in *. pose proof (step_flat t1) as Fp. fold p in Fp.
    assert (Pp : pow z0 a0 p < 0) by (apply step_inside; lra).
    assert (sidep : 0 <= turn (at_ w) (at_ d) p /\ 0 <= turn (at_ d) (at_ u) p).
    { assert (W : within (at_ u) (at_ w) (at_ d) p).
      { apply C1. destruct (in_cell_dec c p Fp) as [I|(u' & w' & Hu2 & L)]; [exact I|exfalso].
        specialize (Gf _ (in_map (fun e => fn (fst e) (snd e)) _ _ Hu2)). cbn [fst snd] in Gf. rewrite fn_val in Gf. fold p in Gf. lra. }
      destruct W as (_ & _ & W2 & W3). auto. }
    destruct sidep as [W2 W3].
    destruct (bary o n n0 (at_ u) (at_ w) (at_ d) p) as (B1 & B2 & B3); try tauto.
    rewrite Zf in B1, B2, B3. pose proof (turn_sum n (at_ u) (at_ w) (at_ d) p) as S. rewrite Zf in S.
    assert (corner : forall b, (b = at_ u \/ b = at_ w) -> p = b -> False).
    { intros b Hb E. assert (pow z (at_ u) p = 0) by (unfold pow; destruct Hb; subst b; rewrite E; lra).
      rewrite (Sz u w p Hu Fp) in H. lra. }
    assert (eqp : forall b, turn (at_ u) (at_ w) (at_ d) * cx p = turn (at_ u) (at_ w) (at_ d) * cx b -> turn (at_ u) (at_ w) (at_ d) * cy p = turn (at_ u) (at_ w) (at_ d) * cy b ->
      turn (at_ u) (at_ w) (at_ d) * cz p = turn (at_ u) (at_ w) (at_ d) * cz b -> p = b).
    { intros b X1 X2 X3. destruct p as [p1 p2 p3], b as [b1 b2 b3]. simpl in *. f_equal; apply (Rmult_eq_reg_l (turn (at_ u) (at_ w) (at_ d))); lra. }
    assert (P2 : 0 < turn (at_ w) (at_ d) p).
    { destruct (Req_dec (turn (at_ w) (at_ d) p) 0) as [E|]; [exfalso|lra]. apply (corner (at_ w)); auto.
      rewrite E in *. apply eqp; rewrite ?B1, ?B2, ?B3; rewrite <- S; ring. }
    assert (P3 : 0 < turn (at_ d) (at_ u) p).
    { destruct (Req_dec (turn (at_ d) (at_ u) p) 0) as [E|]; [exfalso|lra]. apply (corner (at_ u)); auto.
      rewrite E in *. apply eqp; rewrite ?B1, ?B2, ?B3; rewrite <- S; ring. }
    assert (lin : forall e f, turn (at_ u) (at_ w) (at_ d) * turn e f p = turn (at_ w) (at_ d) p * turn e f (at_ u) + turn (at_ d) (at_ u) p * turn e f (at_ w)).
    { intros e f.
      assert (lin : forall r, turn e f r = dot (cross n (minus f e)) (minus r e)) by (intro; unfold Planar.turn, dot, cross, minus; simpl; ring).
      rewrite (lin p), (lin (at_ u)), (lin (at_ w)). revert B1 B2 B3 S. clear.
      generalize (turn (at_ w) (at_ d) p) (turn (at_ d) (at_ u) p) (turn (at_ u) (at_ w) (at_ d)) (cross n (minus f e)).
      generalize p (at_ u) (at_ w) (at_ d). clear. intros p a b c s1 s2 D g B1 B2 B3 S. unfold dot, minus; simpl.
      transitivity (cx g * (D * cx p) + cy g * (D * cy p) + cz g * (D * cz p) - D * (cx g * cx e + cy g * cy e + cz g * cz e)); [ring|].
      rewrite B1, B2, B3, <- S. ring. }
    assert (R2 : 0 < turn (at_ u) (at_ d') p).
    { pose proof (lin (at_ u) (at_ d')) as K. rewrite turn_same, Rmult_0_r, Rplus_0_l in K. rewrite (turn_rot n (at_ w) (at_ u)) in K.
      pose proof (Rmult_lt_0_compat _ _ P3 T2) as K2. rewrite <- K in K2.
      destruct (Rle_dec (turn (at_ u) (at_ d') p) 0) as [L|]; [exfalso|lra].
      assert (0 <= turn (at_ u) (at_ w) (at_ d) * - turn (at_ u) (at_ d') p) by (apply Rmult_le_pos; lra). lra. }
    assert (R3 : 0 < turn (at_ d') (at_ w) p).
    { pose proof (lin (at_ d') (at_ w)) as K. rewrite turn_same', Rmult_0_r, Rplus_0_r in K. rewrite <- (turn_rot n (at_ d') (at_ w) (at_ u)) in K.
      pose proof (Rmult_lt_0_compat _ _ P2 T2) as K2. rewrite <- K in K2.
      destruct (Rle_dec (turn (at_ d') (at_ w) p) 0) as [L|]; [exfalso|lra].
      assert (0 <= turn (at_ u) (at_ w) (at_ d) * - turn (at_ d') (at_ w) p) by (apply Rmult_le_pos; lra). lra. }
    destruct (small_positive [(turn (at_ u) (at_ d') p, turn (at_ u) (at_ d') x); (turn (at_ d') (at_ w) p, turn (at_ d') (at_ w) x)]) as (e & He & Ge).
    { intros f [<-|[<-|[]]]; simpl; assumption. }
    assert (at' : forall f g, turn f g (step (t1 + e * (1-t1))) = val (turn f g p, turn f g x) e).
    { intros f g. unfold p, step, val. rewrite !turn_towards. cbn [fst snd]. ring. }
    assert (Pe : 0 < e * (1-t1)) by (apply Rmult_lt_0_compat; lra).
    assert (Pe' : e * (1-t1) < 1 * (1-t1)) by (apply Rmult_lt_compat_r; lra).
    exists c', (t1 + e * (1-t1)). split; [exact Hc'|]. split; [exact Sc'|]. split; [lra|]. split.
    + apply C2. split; [apply step_flat|]. split; [|split].
      * rewrite at', turn_swap, (turn_swap n (at_ u) (at_ w) x), Zf. unfold val; cbn [fst snd].
        assert (0 < e * - turn (at_ u) (at_ w) x) by (apply Rmult_lt_0_compat; lra). lra.
      * rewrite at'. left. apply Ge; simpl; auto. lra.
      * rewrite at'. left. apply Ge; simpl; auto. lra.
    + intros s Hs Is. apply C1 in Is. destruct Is as (_ & Is & _).
      assert (K : turn (at_ u) (at_ w) (step s) * (1 - t1) = (s - t1) * turn (at_ u) (at_ w) x).
      { unfold step. rewrite turn_towards. assert (Z1 : (1-t1) * turn (at_ u) (at_ w) y = - t1 * turn (at_ u) (at_ w) x).
        { unfold p, step in Zf. rewrite turn_towards in Zf. lra. }
        replace (((1-s) * turn (at_ u) (at_ w) y + s * turn (at_ u) (at_ w) x) * (1-t1)) with ((1-s) * ((1-t1) * turn (at_ u) (at_ w) y) + s * (1-t1) * turn (at_ u) (at_ w) x) by ring.
        rewrite Z1. ring. }
      assert (0 <= turn (at_ u) (at_ w) (step s) * (1 - t1)) by (apply Rmult_le_pos; lra).
      assert (0 < (s - t1) * - turn (at_ u) (at_ w) x) by (apply Rmult_lt_0_compat; lra). lra.
Qed.

Lemma walk : forall len L t, (length L <= len)%nat -> 0 <= t < 1 ->
  (forall c s, In c cells -> same c -> t <= s < 1 -> in_cell c (step s) -> In c L) ->
  forall c, In c cells -> same c -> in_cell c (step t) -> exists c, In c cells /\ in_cell c x.
Proof.
  induction len as [|len IH]; intros L t Hl Ht HL c Hc Sc Ic.
  - exfalso. assert (In c L) by (apply (HL c t); auto; lra). destruct L; [contradiction|simpl in Hl; lia].
  - destruct (leave c t Hc Sc Ht Ic) as [Ix|(c' & t' & Hc' & Sc' & Ht' & Ic' & Out)]; [exists c; auto|].
    apply (IH (filter (fun d => if triple_dec d c then false else true) L) t') with c'; auto; [|lra|].
    + assert (K : forall l : list triple, (length (filter (fun d => if triple_dec d c then false else true) l) <= length l)%nat /\
        (In c l -> (length (filter (fun d => if triple_dec d c then false else true) l) < length l)%nat)).
      { induction l as [|d l [K1 K2]]; [simpl; split; [lia|contradiction]|]. cbn [filter length In]. destruct (triple_dec d c); cbn [length]; split; intros; try lia.
        destruct H as [H|H]; [congruence|]. specialize (K2 H). lia. }
      destruct (K L) as [_ K2]. assert (In c L) by (apply (HL c t); auto; lra). specialize (K2 H). lia.
    + intros d s Hd Sd Hs Id. apply filter_In. split; [apply (HL d s); auto; lra|].
      destruct (triple_dec d c) as [->|]; [exfalso; apply (Out s); auto|reflexivity].
Qed.
End From.

(** The polygon of a cell lies in the union of the cells. *)
Theorem polygon_in_cells : forall c z, In c cells -> good c z -> let '(i, j, k) := c in
  forall p q r x, In p V -> In q V -> In r V -> dist2 z p = dist2 z (at_ i) -> dist2 z q = dist2 z (at_ i) -> dist2 z r = dist2 z (at_ i) ->
  in_triangle p q r x -> exists c', In c' cells /\ in_cell c' x.
Proof.
  intros [[i j] k] z Hc G p q r x Ip Iq Ir Ep Eq Er (l & m & h & Hl & Hm & Hh & S & ->).
  pose proof G as [F1 I1 T1 H1 E1 _]. destruct H1 as [H1 H1'].
  assert (Fl : forall v, In v V -> dist2 z v = dist2 z (at_ i) -> flat_at v) by (intros v Hv; apply (E1 v Hv)).
  set (y := mix3 (at_ i) (at_ j) (at_ k) (1/3) (1/3) (1/3)).
  assert (Fy : flat_at y) by (apply flat_mix3; try tauto; lra).
  apply (walk z (at_ i) (mix3 p q r l m h) y) with (len := length cells) (L := cells) (t := 0) (c := (i, j, k)); auto.
  - apply flat_mix3; auto.
  - unfold y. rewrite pow_mix3 by lra. unfold pow. rewrite H1, H1'.
    assert (N : 0 < dist2 (at_ i) (at_ j)).
    { destruct (Req_dec (dist2 (at_ i) (at_ j)) 0) as [E|E]; [|pose proof (dist2_nonneg (at_ i) (at_ j)); lra].
      apply dist2_zero in E. rewrite E, turn_refl in T1. lra. }
    pose proof (dist2_nonneg (at_ j) (at_ k)). pose proof (dist2_nonneg (at_ k) (at_ i)). lra.
  - intros v Hv K. apply Fl; auto. unfold pow in K. lra.
  - rewrite pow_mix3 by exact S. unfold pow. rewrite Ep, Eq, Er.
    assert (0 <= l*m*dist2 p q) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply dist2_nonneg]).
    assert (0 <= m*h*dist2 q r) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply dist2_nonneg]).
    assert (0 <= h*l*dist2 r p) by (apply Rmult_le_pos; [apply Rmult_le_pos; lra|apply dist2_nonneg]). lra.
  - intros u w K. rewrite turn_mix3 by exact S.
    assert (0 <= turn u w p) by (apply K; auto; unfold pow; lra). assert (0 <= turn u w q) by (apply K; auto; unfold pow; lra).
    assert (0 <= turn u w r) by (apply K; auto; unfold pow; lra).
    repeat apply Rplus_le_le_0_compat; apply Rmult_le_pos; assumption.
  - lra.
  - exists z. split; [exact G|]. intros u w v Hu Fv. unfold pow. cbn [sides In] in Hu.
    destruct Hu as [Hu|[Hu|[Hu|[]]]]; injection Hu; intros; subst u w; lra.
  - unfold step, in_cell. replace (towards y (mix3 p q r l m h) 0) with y by (destruct y; unfold towards; simpl; f_equal; ring).
    apply triangle_within; try tauto; [lra|]. exists (1/3), (1/3), (1/3). repeat split; try lra.
Qed.
End Walk.
