(* SPDX-License-Identifier: Apache-2.0 *)
(** * Soundness: an accepted certificate proves conformity *)
From Coq Require Import ZArith Arith List Bool Lia Reals Lra Psatz FMapPositive.
From Confidel.checker Require Import Space Statement Support Planar Crossing Walk Cover Region Check Arithmetic Tables Cells.
Import ListNotations.
Open Scope R_scope.

(** ** Subdivided segments *)
Lemma towards_left p q s y : 0 < s < 1 -> on_segment p (towards p q s) y -> on_segment p q y.
Proof.
  intros Hs (r & Hr & ->). exists (r * s). split; [split|].
  - apply Rmult_le_pos; lra.
  - assert (r * s <= 1 * s) by (apply Rmult_le_compat_r; lra). lra.
  - unfold towards; simpl. f_equal; ring.
Qed.
Lemma towards_right p q s y : 0 < s < 1 -> on_segment (towards p q s) q y -> on_segment p q y.
Proof.
  intros Hs (r & Hr & ->). exists (s + r * (1 - s)). assert (0 <= r * (1-s)) by (apply Rmult_le_pos; lra).
  assert (r * (1-s) <= 1 * (1-s)) by (apply Rmult_le_compat_r; lra). split; [lra|]. unfold towards; simpl. f_equal; ring.
Qed.
Lemma towards_split p q s y : 0 < s < 1 -> on_segment p q y -> on_segment p (towards p q s) y \/ on_segment (towards p q s) q y.
Proof.
  intros Hs (r & Hr & ->). destruct (Rle_dec r s) as [L|L].
  - left. assert (I : 0 < / s) by (apply Rinv_0_lt_compat; lra). exists (r / s). split; [split|].
    + apply Rmult_le_pos; lra. + apply (Rmult_le_reg_r s); [lra|]. replace (r/s*s) with r by (field; lra). lra.
    + unfold towards; simpl. f_equal; field; lra.
  - right. assert (I : 0 < / (1 - s)) by (apply Rinv_0_lt_compat; lra). exists ((r-s) / (1-s)). split; [split|].
    + apply Rmult_le_pos; lra. + apply (Rmult_le_reg_r (1-s)); [lra|]. replace ((r-s)/(1-s)*(1-s)) with (r-s) by (field; lra). lra.
    + unfold towards; simpl. f_equal; field; lra.
Qed.
Lemma towards_distinct p q s : 0 < s < 1 -> p <> q -> p <> towards p q s /\ towards p q s <> q.
Proof.
  intros Hs N. destruct p as [p1 p2 p3], q as [q1 q2 q3]. unfold towards; simpl.
  assert (G : forall a b, a = a + s * (b - a) -> a = b) by (intros a b K; assert (Z : s * (b - a) = 0) by lra; apply Rmult_integral in Z; lra).
  assert (G' : forall a b, a + s * (b - a) = b -> a = b) by (intros a b K; assert (Z : (1 - s) * (b - a) = 0) by lra; apply Rmult_integral in Z; lra).
  split; intro K; injection K; intros K3 K2 K1; apply N; f_equal; auto.
Qed.
Lemma planar_inside p q r a b s : 0 < s < 1 -> inside (planar p q r a) (planar p q r (towards a b s)) (planar p q r b).
Proof. intro Hs. exists s. split; [exact Hs|]. unfold planar, towards, dot, minus; simpl. split; ring. Qed.

Section Sound.
Variables (K : complex) (V : list point) (m : points) (sm : segments) (t : pairs) (tr : tree) (g : Z) (T : list simplex).
Hypothesis table_in : forall k p c, find k m = Some (p, c) -> (0 < hw p)%Z /\ In (real p) V.
Hypothesis table_all : forall v, In v V -> exists k p c, find k m = Some (p, c) /\ real p = v /\ in_tree k tr.
Hypothesis table_vertex : forall k p, find k m = Some (p, AtVertex) -> place K k = real p.
Hypothesis tree_fine : tree_ok m g tr = true.
Hypothesis g_pos : (0 < g)%Z.
Hypothesis segments_fine : forall j s, find j sm = Some s -> segment_fine m j s.
Hypothesis D : covering V T.
Notation at_ := (at_ m).

Lemma vertex_place k : is_vertex m k = true -> at_ k = place K k.
Proof.
  unfold is_vertex, Cells.at_. destruct (find k m) as [[p [| |]]|] eqn:E; try discriminate. intros _. symmetry. apply table_vertex. exact E.
Qed.
Lemma distinct_sound a b : distinct_places m a b = true -> at_ a <> at_ b.
Proof.
  unfold distinct_places, Cells.at_. destruct (find a m) as [[p c]|] eqn:Ea; [|discriminate]. destruct (find b m) as [[q c']|] eqn:Eb; [|discriminate].
  intros H E. apply negb_true_iff in H. destruct (table_in _ _ _ Ea) as [P _]. destruct (table_in _ _ _ Eb) as [Q _]. pos P. pos Q.
  unfold real in E. injection E; intros E3 E2 E1.
  assert (G : forall x y, IZR x / IZR (hw p) = IZR y / IZR (hw q) -> (x * hw q =? y * hw p)%Z = true).
  { intros x y E0. apply Z.eqb_eq, eq_IZR. rewrite !mult_IZR. apply (f_equal (fun z => z * (IZR (hw p) * IZR (hw q)))) in E0. field_simplify in E0; lra. }
  apply G in E1, E2, E3. rewrite E1, E2, E3 in H. discriminate.
Qed.

(** the points of a chain, and its pieces *)
Lemma chain_pieces s : forall ms a b, chain_ok m s a ms b = true -> at_ a <> at_ b -> forall e, In e (links a ms b) ->
  at_ (fst e) <> at_ (snd e) /\ forall y, on_segment (at_ (fst e)) (at_ (snd e)) y -> on_segment (at_ a) (at_ b) y.
Proof.
  induction ms as [|k ms IH]; intros a b H N e He; cbn [links In] in He.
  - destruct He as [<-|[]]. auto.
  - cbn [chain_ok] in H. destruct (find a m) as [[p ca]|] eqn:Ea; [|discriminate]. destruct (find k m) as [[x [|j|]]|] eqn:Ek; try discriminate.
    destruct (find b m) as [[q cb]|] eqn:Eb; [|discriminate]. apply andb_true_iff in H. destruct H as [H H2]. apply andb_true_iff in H. destruct H as [_ H1].
    destruct (between_sound p x q (proj1 (table_in _ _ _ Ea)) (proj1 (table_in _ _ _ Ek)) (proj1 (table_in _ _ _ Eb)) H1) as (r & Hr & E).
    rewrite <- (at_find m _ _ _ Ea), <- (at_find m _ _ _ Eb), <- (at_find m _ _ _ Ek) in E.
    destruct (towards_distinct _ _ _ Hr N) as [N1 N2]. rewrite <- E in N1, N2.
    destruct He as [<-|He]; cbn [fst snd].
    + split; [exact N1|]. intros y Hy. rewrite E in Hy. eapply towards_left; eauto.
    + destruct (IH k b H2 N2 e He) as [A B]. split; [exact A|]. intros y Hy. apply B in Hy. rewrite E in Hy. eapply towards_right; eauto.
Qed.
Lemma chain_covers s : forall ms a b, chain_ok m s a ms b = true -> forall y, on_segment (at_ a) (at_ b) y ->
  exists e, In e (links a ms b) /\ on_segment (at_ (fst e)) (at_ (snd e)) y.
Proof.
  induction ms as [|k ms IH]; intros a b H y Hy; cbn [links In].
  - exists (a, b). auto.
  - cbn [chain_ok] in H. destruct (find a m) as [[p ca]|] eqn:Ea; [|discriminate]. destruct (find k m) as [[x [|j|]]|] eqn:Ek; try discriminate.
    destruct (find b m) as [[q cb]|] eqn:Eb; [|discriminate]. apply andb_true_iff in H. destruct H as [H H2]. apply andb_true_iff in H. destruct H as [_ H1].
    destruct (between_sound p x q (proj1 (table_in _ _ _ Ea)) (proj1 (table_in _ _ _ Ek)) (proj1 (table_in _ _ _ Eb)) H1) as (r & Hr & E).
    rewrite <- (at_find m _ _ _ Ea), <- (at_find m _ _ _ Eb), <- (at_find m _ _ _ Ek) in E.
    destruct (towards_split _ _ r _ Hr Hy) as [L|L]; rewrite <- E in L.
    + exists (a, k). auto.
    + destruct (IH k b H2 y L) as (e & He & L'). exists e. auto.
Qed.
Lemma chain_crossing P Q R0 y s : forall ms a b, chain_ok m s a ms b = true ->
  sum (edge_crossing P Q R0 at_ y) (links a ms b) = edge_crossing P Q R0 at_ y (a, b).
Proof.
  induction ms as [|k ms IH]; intros a b H; cbn [links].
  - cbn [sum fold_right]. lia.
  - cbn [chain_ok] in H. destruct (find a m) as [[p ca]|] eqn:Ea; [|discriminate]. destruct (find k m) as [[x [|j|]]|] eqn:Ek; try discriminate.
    destruct (find b m) as [[q cb]|] eqn:Eb; [|discriminate]. apply andb_true_iff in H. destruct H as [H H2]. apply andb_true_iff in H. destruct H as [_ H1].
    destruct (between_sound p x q (proj1 (table_in _ _ _ Ea)) (proj1 (table_in _ _ _ Ek)) (proj1 (table_in _ _ _ Eb)) H1) as (r & Hr & E).
    rewrite <- (at_find m _ _ _ Ea), <- (at_find m _ _ _ Eb), <- (at_find m _ _ _ Ek) in E.
    cbn [sum fold_right]. fold (sum (edge_crossing P Q R0 at_ y) (links k ms b)). rewrite (IH k b H2). unfold edge_crossing; cbn [fst snd].
    symmetry. apply crossing_split. rewrite E. apply planar_inside. exact Hr.
Qed.
Lemma chain_ends s : forall ms a b, chain_ok m s a ms b = true -> forall e, In e (links a ms b) ->
  (fst e = a \/ exists p, find (fst e) m = Some (p, OnSegment s)) /\ (snd e = b \/ exists p, find (snd e) m = Some (p, OnSegment s)).
Proof.
  induction ms as [|k ms IH]; intros a b H e He; cbn [links In] in He.
  - destruct He as [<-|[]]. auto.
  - cbn [chain_ok] in H. destruct (find a m) as [[p ca]|] eqn:Ea; [|discriminate]. destruct (find k m) as [[x [|j|]]|] eqn:Ek; try discriminate.
    destruct (find b m) as [[q cb]|] eqn:Eb; [|discriminate]. apply andb_true_iff in H. destruct H as [H H2]. apply andb_true_iff in H. destruct H as [H0 _].
    apply number_eqb_spec in H0. subst j.
    destruct He as [<-|He]; cbn [fst snd]; [split; [auto|right; eauto]|].
    destruct (IH k b H2 e He) as [[A|A] B]; split; auto. right. rewrite A. eauto.
Qed.
Lemma link_lies_on x k s : find k sm = Some s -> directed sm t (g_a s) (g_b s) = Some (k, s) -> mem k (x_segments x) = true ->
  forall e, In e (links (g_a s) (g_ms s) (g_b s)) -> lies_on m sm t x (fst e) (snd e) = true /\ lies_on m sm t x (snd e) (fst e) = true.
Proof.
  intros Hk Hd Hx e He. destruct (segments_fine _ _ Hk) as (Va & Vb & _ & Ch). unfold is_vertex in *.
  destruct (chain_ends _ _ _ _ Ch e He) as [A B].
  destruct (find (g_a s) m) as [[pa [| |]]|] eqn:Ea; try discriminate. destruct (find (g_b s) m) as [[pb [| |]]|] eqn:Eb; try discriminate.
  unfold lies_on.
  destruct A as [A|[p A]], B as [B|[q B]]; rewrite ?A, ?B, ?Ea, ?Eb; unfold is_end; rewrite ?Hk.
  - unfold in_context. rewrite Hd, Hx. cbn [orb]. split; [reflexivity|]. apply orb_true_r.
  - unfold number_eqb. rewrite Hx, Pos.eqb_refl. auto.
  - unfold number_eqb. rewrite Hx, Pos.eqb_refl, orb_true_r. auto.
  - unfold number_eqb. rewrite Hx, Pos.eqb_refl. auto.
Qed.

(** ** Contexts *)
Lemma plane_of_sound F pl : plane_of m F = Some pl -> (0 < p_w pl)%Z /\ over (p_w pl) (p_o pl) = place K (f_i F) /\
  rvec (p_n pl) = scale (IZR (p_w2 pl)) (normal (place K (f_i F)) (place K (f_j F)) (place K (f_k F))) /\ (0 < p_w2 pl)%Z.
Proof.
  unfold plane_of. destruct (find (f_i F) m) as [[p [| |]]|] eqn:Ei; try discriminate. destruct (find (f_j F) m) as [[q [| |]]|] eqn:Ej; try discriminate.
  destruct (find (f_k F) m) as [[r [| |]]|] eqn:Ek; try discriminate. destruct (common p q r) as [[[w a] b] c] eqn:E.
  destruct (common_sound _ _ _ _ _ _ _ (proj1 (table_in _ _ _ Ei)) (proj1 (table_in _ _ _ Ej)) (proj1 (table_in _ _ _ Ek)) E) as (W & E1 & E2 & E3).
  rewrite (table_vertex _ _ Ei), (table_vertex _ _ Ej), (table_vertex _ _ Ek). intro H. injection H; intros; subst pl; cbn [p_w p_o p_n p_w2].
  split; [exact W|]. split; [auto|]. split; [|apply Z.mul_pos_pos; exact W].
  rewrite rvec_cross, !(over_minus w), cross_scale, mult_IZR by exact W. unfold normal. rewrite E1, E2, E3. reflexivity.
Qed.
Lemma add_pair_none : forall es, fold_left (add_pair sm t) es None = None.
Proof. induction es; auto. Qed.
Lemma add_pair_spec : forall es vs ss vs' ss', fold_left (add_pair sm t) es (Some (vs, ss)) = Some (vs', ss') ->
  (forall k, mem k ss = true -> mem k ss' = true) /\
  forall e, In e es -> exists k s d, segment_between sm t (fst e) (snd e) = Some (k, s, d) /\ mem k ss' = true.
Proof.
  induction es as [|e es IH]; intros vs ss vs' ss' H.
  - simpl in H. injection H; intros; subst. split; [auto|intros ? []].
  - cbn [fold_left] in H. unfold add_pair at 2 in H. destruct (segment_between sm t (fst e) (snd e)) as [[[k s] d]|] eqn:E; [|rewrite add_pair_none in H; discriminate].
    destruct (IH _ _ _ _ H) as [A B]. split.
    + intros j J. apply A. apply mem_insert. auto.
    + intros e' [<-|I]; [|auto]. exists k, s, d. split; [exact E|]. apply A. apply mem_insert. auto.
Qed.
Lemma context_of_spec k F x : context_of m sm t k F = Some x -> plane_of m F = Some (x_plane x) /\
  forall e, In e (f_boundary F) \/ In e (f_inner F) -> exists k s d, segment_between sm t (fst e) (snd e) = Some (k, s, d) /\ mem k (x_segments x) = true.
Proof.
  unfold context_of. destruct (plane_of m F) as [pl|]; [|discriminate].
  destruct (fold_left (add_pair sm t) (f_boundary F) _) as [[vs ss]|] eqn:E1; [|rewrite add_pair_none; discriminate].
  destruct (fold_left (add_pair sm t) (f_inner F) _) as [[vs' ss']|] eqn:E2; [|discriminate].
  intro H. injection H; intros; subst x; cbn [x_plane x_segments]. split; [reflexivity|].
  destruct (add_pair_spec _ _ _ _ _ E1) as [_ B1]. destruct (add_pair_spec _ _ _ _ _ E2) as [A2 B2].
  intros e [I|I]; [|auto]. destruct (B1 e I) as (j & s & d & S1 & S2). exists j, s, d. split; [exact S1|]. apply A2. exact S2.
Qed.

(** ** One facet *)
Section Facet.
Variables (k : number) (F : facet) (cs : list cell) (x : context).
Hypothesis Hx : context_of m sm t k F = Some x.
Hypothesis Hv : facet_vertices_ok m (x_plane x) F = true.
Hypothesis Ht : tiling_ok sm t F cs = true.
Hypothesis Hc : forallb (cell_ok m sm t tr g x) cs = true.
Let P := place K (f_i F).
Let Q := place K (f_j F).
Let R0 := place K (f_k F).
Let N := normal P Q R0.
Let fixed u w := lies_on m sm t x u w = true.
Let cells := map triple_of cs.

Lemma cells_good : forall c, In c cells -> exists z, good P N V at_ fixed c z.
Proof.
  intros c Ic. apply in_map_iff in Ic. destruct Ic as (c' & <- & Ic). rewrite forallb_forall in Hc.
  destruct (context_of_spec _ _ _ Hx) as [Hp _]. destruct (plane_of_sound _ _ Hp) as (A & B & C & E).
  apply (cell_sound V m sm t tr g table_in table_all tree_fine g_pos x P N (IZR (p_w2 (x_plane x))) A B (IZR_pos _ E) C E c' (Hc _ Ic)).
Qed.
Lemma normal_nonzero : N <> origin.
Proof.
  intro Z. unfold tiling_ok in Ht. assert (Ne : exists c, In c cs).
  { destruct cs as [|c l]; [|exists c; left; reflexivity]. exfalso.
    destruct (fold_left add_cell [] _); [|discriminate]. destruct (fold_left (add_boundary sm t) (f_boundary F) _); [|discriminate]. rewrite andb_false_r in Ht. discriminate. }
  destruct Ne as [c Ic]. destruct (cells_good (triple_of c) (in_map _ _ _ Ic)) as [z [_ _ Tn _ _ _]]. unfold triple_of in Tn. rewrite Z in Tn.
  unfold turn, dot, origin in Tn; simpl in Tn. lra.
Qed.
(** the sets of edges *)
Lemma tiling_facts : exists E B, 
  (forall e, has E e = true <-> In e (flat_map sides cells)) /\ NoDup (flat_map sides cells) /\
  (forall e, has B e = true <-> In e (flat_map (boundary_links sm t) (f_boundary F))) /\ NoDup (flat_map (boundary_links sm t) (f_boundary F)) /\
  (forall e, In e (flat_map sides cells) -> xorb (has E (swap e)) (has B e) = true) /\
  (forall e, In e (f_boundary F) -> covers sm t (has E) e = true) /\
  (forall e, In e (f_inner F) -> covers sm t (fun e => has E e || has E (swap e)) e = true).
Proof.
  unfold tiling_ok in Ht.
  destruct (fold_left add_cell cs _) as [E|] eqn:H1; [|discriminate]. destruct (fold_left (add_boundary sm t) (f_boundary F) _) as [B|] eqn:H2; [|discriminate].
  exists E, B. rewrite add_cells_spec in H1. destruct (add_edges_spec _ _ _ H1) as (E1 & E2 & _).
  destruct (add_boundary_spec _ _ _ _ _ H2) as [H2' _]. destruct (add_edges_spec _ _ _ H2') as (B1 & B2 & _).
  apply andb_true_iff in Ht. destruct Ht as [Ht1 _]. apply andb_true_iff in Ht1. destruct Ht1 as [Ht2 _]. apply andb_true_iff in Ht2. destruct Ht2 as [Ht3 Hin].
  apply andb_true_iff in Ht3. destruct Ht3 as [Hpair Hcov]. rewrite forallb_forall in Hin, Hpair, Hcov.
  split; [|split; [exact E2|split; [|split; [exact B2|split; [|split; [exact Hcov|exact Hin]]]]]].
  - intro e. rewrite E1, has_empty. split; [intros [|]; [discriminate|assumption]|auto].
  - intro e. rewrite B1, has_empty. split; [intros [|]; [discriminate|assumption]|auto].
  - intros e I. apply in_flat_map in I. destruct I as (c & Ic & I). apply in_map_iff in Ic. destruct Ic as (c' & <- & Ic).
    specialize (Hpair c' Ic). unfold cell_paired, edge_paired in Hpair. apply andb_true_iff in Hpair. destruct Hpair as [Hp P3]. apply andb_true_iff in Hp. destruct Hp as [P1 P2].
    unfold triple_of, sides in I. cbn [In] in I. destruct I as [<-|[<-|[<-|[]]]]; assumption.
Qed.
Lemma boundary_link e : In e (flat_map (boundary_links sm t) (f_boundary F)) ->
  lies_on m sm t x (fst e) (snd e) = true.
Proof.
  intro I. apply in_flat_map in I. destruct I as (b & Ib & I). destruct (context_of_spec _ _ _ Hx) as [_ C].
  destruct (C b (or_introl Ib)) as (j & s & d & Sb & M). destruct (segment_between_spec _ _ _ _ _ _ _ Sb) as (Fj & Dj & _).
  unfold boundary_links in I. rewrite Sb in I. destruct d.
  - apply (link_lies_on x j s Fj Dj M e I).
  - apply in_map_iff in I. destruct I as (e' & <- & I). cbn [swap fst snd]. apply (link_lies_on x j s Fj Dj M e' I).
Qed.
Lemma cells_paired : forall c u w, In c cells -> In (u, w) (sides c) -> fixed u w \/ exists c', In c' cells /\ In (w, u) (sides c').
Proof.
  intros c u w Ic I. destruct tiling_facts as (E & B & E1 & _ & B1 & _ & X & _).
  assert (Ie : In (u, w) (flat_map sides cells)) by (apply in_flat_map; eauto). specialize (X _ Ie). unfold swap in X; cbn [fst snd] in X.
  destruct (has B (u, w)) eqn:Hb; [left|right].
  - apply B1 in Hb. apply (boundary_link (u, w) Hb).
  - rewrite xorb_false_r in X. apply E1 in X. apply in_flat_map in X. exact X.
Qed.
Lemma at_pair e : In e (f_boundary F) -> at_ (fst e) = place K (fst e) /\ at_ (snd e) = place K (snd e).
Proof.
  intro I. unfold facet_vertices_ok in Hv. apply andb_true_iff in Hv. destruct Hv as [Hv1 _]. apply andb_true_iff in Hv1. destruct Hv1 as [Hv2 _].
  rewrite forallb_forall in Hv2. specialize (Hv2 e I). apply andb_true_iff in Hv2. destruct Hv2 as [A B]. unfold vertex_on_plane in *.
  apply andb_true_iff in A, B. split; apply vertex_place; tauto.
Qed.
Lemma crossing_anti y e : edge_crossing P Q R0 at_ y (swap e) = (- edge_crossing P Q R0 at_ y e)%Z.
Proof. unfold edge_crossing, swap; cbn [fst snd]. apply crossing_swap. Qed.
Lemma winding_cells y : facet_winding K F y = sum (edge_crossing P Q R0 at_ y) (flat_map sides cells).
Proof.
  destruct tiling_facts as (E & B & E1 & E2 & B1 & B2 & X & Cv & _).
  rewrite (cancel (flat_map sides cells) (flat_map (boundary_links sm t) (f_boundary F))); auto.
  - (* chains *)
    unfold facet_winding. assert (G : forall l, incl l (f_boundary F) ->
      winding (map (fun e => (facet_planar K F (place K (fst e)), facet_planar K F (place K (snd e)))) l) (facet_planar K F y) =
      sum (edge_crossing P Q R0 at_ y) (flat_map (boundary_links sm t) l)).
    { induction l as [|e l IH]; intro L; [reflexivity|]. cbn [map winding fold_right flat_map]. rewrite sum_app, <- IH by (intros z Z; apply L; right; exact Z).
      unfold winding. f_equal. destruct (at_pair e) as [A1 A2]; [apply L; left; reflexivity|].
      destruct (context_of_spec _ _ _ Hx) as [_ C]. destruct (C e) as (j & s & d & Sb & _); [left; apply L; left; reflexivity|].
      destruct (segment_between_spec _ _ _ _ _ _ _ Sb) as (Fj & _ & Ej). destruct (segments_fine _ _ Fj) as (_ & _ & _ & Ch).
      unfold boundary_links. rewrite Sb.
      assert (Q0 : crossing (facet_planar K F y) (facet_planar K F (place K (fst e))) (facet_planar K F (place K (snd e))) = edge_crossing P Q R0 at_ y e).
      { unfold edge_crossing. rewrite A1, A2. reflexivity. }
      cbn [fst snd]. rewrite Q0. destruct d; destruct Ej as [J1 J2]; cbv beta iota.
      - etransitivity; [|symmetry; apply (chain_crossing P Q R0 y j _ _ _ Ch)]. rewrite J1, J2. destruct e; reflexivity.
      - etransitivity; [|symmetry; apply sum_swap; apply crossing_anti]. 
        etransitivity; [|apply f_equal; symmetry; apply (chain_crossing P Q R0 y j _ _ _ Ch)]. rewrite J1, J2.
        etransitivity; [|apply crossing_anti]. destruct e; reflexivity. }
    apply G, incl_refl.
  - intros e I. apply E1. apply in_flat_map in I. destruct I as (b & Ib & I). specialize (Cv b Ib). unfold covers in Cv. unfold boundary_links in I.
    destruct (segment_between sm t (fst b) (snd b)) as [[[j s] [|]]|]; [| |discriminate]; rewrite all_links_spec, forallb_forall in Cv.
    + apply Cv. exact I.
    + apply in_map_iff in I. destruct I as (e' & <- & I). apply Cv. exact I.
  - intros e I. specialize (X e I). destruct (has E (swap e)) eqn:H1, (has B e) eqn:H2; try discriminate.
    + left. split; [apply E1; exact H1|]. intro I'. apply B1 in I'. congruence.
    + right. split; [intro I'; apply E1 in I'; congruence|apply B1; exact H2].
  - apply crossing_anti.
Qed.
Lemma flat_cells : forall c, In c cells -> let '(i, j, l) := c in
  flat_at P N (at_ i) /\ flat_at P N (at_ j) /\ flat_at P N (at_ l) /\ 0 < turn N (at_ i) (at_ j) (at_ l).
Proof.
  intros c Ic. destruct (cells_good c Ic) as [z [Fl _ Tn _ _ _]]. destruct c as [[i j] l]. tauto.
Qed.
Lemma in_cell_region : forall c y, In c cells -> in_cell P N at_ c y -> region K F y.
Proof.
  intros c y Ic I. split.
  - destruct c as [[i j] l]. destruct I as [I _]. exact I.
  - intros eps He. apply (inside_region P Q R0 normal_nonzero at_ cells flat_cells (facet_winding K F) winding_cells c y Ic I eps He).
Qed.

Theorem facet_union : forall y, region K F y -> exists u v w, face_of T u v w /\ in_triangle u v w y /\ forall y', in_triangle u v w y' -> region K F y'.
Proof.
  intros y [Fy Cl].
  destruct (region_inside P Q R0 normal_nonzero at_ cells flat_cells (facet_winding K F) winding_cells y Fy Cl) as (c & Ic & I).
  destruct (cells_good c Ic) as [z G]. pose proof (polygon_in_cells P N normal_nonzero V at_ cells fixed cells_good cells_paired c z Ic G) as Poly.
  pose proof G as [Fl Iv Tn Th Em _]. destruct c as [[i j] l]. destruct Fl as (F1 & F2 & F3), Iv as (I1 & I2 & I3), Th as (T1 & T2).
  destruct (cell_covered P N normal_nonzero V T D z (at_ i) (at_ j) (at_ l) F1 F2 F3 I1 I2 I3 Tn T1 T2 Em y I) as (u & v & w & Fa & In3 & Vu & Vv & Vw & Eu & Ev & Ew).
  exists u, v, w. split; [exact Fa|]. split; [exact In3|].
  intros y' Iy'. destruct (Poly u v w y' Vu Vv Vw Eu Ev Ew Iy') as (c' & Ic' & I'). apply (in_cell_region c' y' Ic' I').
Qed.
Theorem facet_edges : forall e j s d, In e (f_boundary F) \/ In e (f_inner F) -> segment_between sm t (fst e) (snd e) = Some (j, s, d) ->
  forall f, In f (links (g_a s) (g_ms s) (g_b s)) -> edge_of T (at_ (fst f)) (at_ (snd f)).
Proof.
  intros e j s d Ie Sb f If. destruct tiling_facts as (E & B & E1 & _ & _ & _ & _ & Cv & Ci).
  destruct (context_of_spec _ _ _ Hx) as [_ C]. destruct (C e Ie) as (j' & s' & d' & Sb' & M). rewrite Sb in Sb'. injection Sb'; intros; subst j' s' d'.
  destruct (segment_between_spec _ _ _ _ _ _ _ Sb) as (Fj & Dj & _). destruct (link_lies_on x j s Fj Dj M f If) as [L1 L2].
  assert (H : has E f = true \/ has E (swap f) = true).
  { destruct Ie as [Ie|Ie]; [specialize (Cv e Ie); unfold covers in Cv; rewrite Sb in Cv; destruct d; rewrite all_links_spec, forallb_forall in Cv; auto|].
    specialize (Ci e Ie). unfold covers in Ci. rewrite Sb in Ci. destruct d; rewrite all_links_spec, forallb_forall in Ci; specialize (Ci f If); apply orb_true_iff in Ci; rewrite ?swap_swap in Ci; tauto. }
  destruct H as [H|H]; apply E1 in H; apply in_flat_map in H; destruct H as (c & Ic & H); destruct (cells_good c Ic) as [z G].
  - destruct f as [u w]. cbn [fst snd] in *. apply (fixed_edge P N V at_ fixed T c z u w normal_nonzero D G H L1).
  - destruct f as [u w]. unfold swap in H. cbn [fst snd] in *.
    destruct (fixed_edge P N V at_ fixed T c z w u normal_nonzero D G H L2) as (Ne & tt & A & B1 & B2). split; [auto|]. exists tt. auto.
Qed.
End Facet.

Lemma facets_ok_spec : forall Fs cs k, facets_ok m sm t tr g k Fs cs = true -> forall F, In F Fs -> exists k' cs', facet_ok m sm t tr g k' F cs' = true.
Proof.
  induction Fs as [|F Fs IH]; intros cs k H F' I; [contradiction|]. destruct cs as [|c cs]; [discriminate|]. cbn [facets_ok] in H. apply andb_true_iff in H. destruct H as [H1 H2].
  destruct I as [<-|I]; [eauto|]. eapply IH; eauto.
Qed.
Lemma facet_ok_spec k F cs : facet_ok m sm t tr g k F cs = true -> exists x, context_of m sm t k F = Some x /\ facet_vertices_ok m (x_plane x) F = true /\
  tiling_ok sm t F cs = true /\ forallb (cell_ok m sm t tr g x) cs = true.
Proof.
  unfold facet_ok. destruct (context_of m sm t k F) as [x|]; [|discriminate]. intro H. exists x. bools. auto.
Qed.
Lemma use_spec : forall es s j, mem j (fold_left (use sm t) es s) = true -> mem j s = true \/ exists e h d, In e es /\ segment_between sm t (fst e) (snd e) = Some (j, h, d).
Proof.
  induction es as [|e es IH]; intros s j H; [auto|]. cbn [fold_left] in H. apply IH in H. destruct H as [H|(e' & h & d & I & S)]; [|right; exists e', h, d; split; [right; exact I|exact S]].
  unfold use in H. destruct (segment_between sm t (fst e) (snd e)) as [[[i h] d]|] eqn:Sb; [|auto]. apply mem_insert in H. destruct H as [->|H]; [|auto].
  right. exists e, h, d. split; [left; reflexivity|exact Sb].
Qed.
Lemma used_spec Fs j : mem j (used sm t Fs) = true -> exists F e h d, In F Fs /\ (In e (f_boundary F) \/ In e (f_inner F)) /\ segment_between sm t (fst e) (snd e) = Some (j, h, d).
Proof.
  unfold used. assert (G : forall l s, mem j (fold_left (fun s F => fold_left (use sm t) (f_inner F) (fold_left (use sm t) (f_boundary F) s)) l s) = true ->
    mem j s = true \/ exists F e h d, In F l /\ (In e (f_boundary F) \/ In e (f_inner F)) /\ segment_between sm t (fst e) (snd e) = Some (j, h, d)).
  { induction l as [|F l IH]; intros s H; [auto|]. cbn [fold_left] in H. apply IH in H.
    destruct H as [H|(F' & e & h & d & A & B)]; [|right; exists F', e, h, d; split; [right; exact A|exact B]].
    apply use_spec in H. destruct H as [H|(e & h & d & I & S)]; [|right; exists F, e, h, d; split; [left; reflexivity|split; [auto|exact S]]].
    apply use_spec in H. destruct H as [H|(e & h & d & I & S)]; [auto|]. right; exists F, e, h, d; split; [left; reflexivity|split; [auto|exact S]]. }
  intro H. apply G in H. rewrite mem_empty in H. destruct H; [discriminate|assumption].
Qed.
Lemma hanging_links : forall ms a b qs s, chain_ok m s a ms b = true -> at_ a <> at_ b -> hanging_ok m tr g a ms b qs = true ->
  forall e, In e (links a ms b) -> edge_of T (at_ (fst e)) (at_ (snd e)).
Proof.
  intros ms a b qs s Ch Ne. pose proof (fun e He => proj1 (chain_pieces s ms a b Ch Ne e He)) as Dis. clear Ch Ne. revert a b qs Dis.
  induction ms as [|k ms IH]; intros a b qs Dis H e He; cbn [links] in *.
  - destruct qs as [|q [|? ?]]; try discriminate. cbn [hanging_ok] in H. destruct He as [<-|[]]. cbn [fst snd].
    apply (subsegment_sound V m tr g table_in table_all tree_fine g_pos T a b q D); [apply (Dis (a, b)); left; reflexivity|exact H].
  - destruct qs as [|q qs]; [discriminate|]. cbn [hanging_ok] in H. apply andb_true_iff in H. destruct H as [H1 H2]. destruct He as [<-|He]; cbn [fst snd].
    + apply (subsegment_sound V m tr g table_in table_all tree_fine g_pos T a k q D); [apply (Dis (a, k)); left; reflexivity|exact H1].
    + apply (IH k b qs); auto. intros e' I. apply Dis. right. exact I.
Qed.
End Sound.

(** ** The theorem *)
(** All points: the vertices of the complex, then the certificate's Steiner points. *)
Definition all_points (K : complex) (C : certificate) : list point := map real (c_vertices K) ++ map (fun q => real (fst q)) (d_steiner C).

Theorem check_covering : forall K C, check K C = true -> forall T, covering (all_points K C) T -> conforms K T.
Proof.
  intros K C H T D. unfold check in H.
  destruct (load_vertices _ _ _ _) as [[[k ws] m0]|] eqn:L1; [|discriminate]. destruct (load_steiner _ _ _ _) as [[k2 m]|] eqn:L2; [|discriminate].
  destruct (load_segments _ _ _ _ _) as [sm|] eqn:L3; [|discriminate].
  set (t := load_pairs _ _ _) in *. set (g := d_scale C) in *. set (tr := d_tree C) in *.
  destruct (load_vertices_spec _ _ _ _ _ _ _ L1) as (A1 & _ & A3 & A4). destruct (load_steiner_spec _ _ _ _ _ _ L2) as (B1 & B2 & B3).
  destruct (load_segments_spec _ _ _ _ _ _ L3) as (_ & S2 & S3).
  rewrite Pos2Nat.inj_1 in *.
  apply andb_true_iff in H. destruct H as [H Hseg]. apply andb_true_iff in H. destruct H as [H Hfac]. apply andb_true_iff in H. destruct H as [H Hin2].
  apply andb_true_iff in H. destruct H as [H Hin1]. apply andb_true_iff in H. destruct H as [Hg Htree]. apply Z.ltb_lt in Hg. unfold zero in Hg.
  set (V := all_points K C) in *.
  assert (table_in : forall j p c, find j m = Some (p, c) -> (0 < hw p)%Z /\ In (real p) V).
  { intros j p c E. unfold V, all_points. destruct (B3 j p c E) as [E1|(_ & v & I & Er & W)].
    - destruct (A4 j p c E1) as [E0|(i & v & I & _ & _ & Er & W)]; [rewrite PositiveMap.gempty in E0; discriminate|].
      split; [exact W|]. apply in_or_app. left. rewrite Er. apply in_map. eapply nth_error_In; eauto.
    - split; [exact W|]. apply in_or_app. right. rewrite Er. apply (in_map (fun q => real (fst q))). exact I. }
  assert (keep : forall j, (Pos.to_nat j < Pos.to_nat k)%nat -> find j m = find j m0) by exact B1.
  assert (table_all : forall v, In v V -> exists j p c, find j m = Some (p, c) /\ real p = v /\ in_tree j tr).
  { intros v I. unfold V, all_points in I. apply in_app_or in I. destruct I as [I|I]; apply in_map_iff in I; destruct I as (u & <- & I); apply In_nth_error in I; destruct I as [i I].
    - destruct (A3 i u I) as (j & p & J & E & Er & _). exists j, p, AtVertex.
      assert (i < length (c_vertices K))%nat by (apply nth_error_Some; congruence).
      split; [rewrite keep by lia; exact E|]. split; [exact Er|].
      pose proof (all_in_spec _ _ _ _ Hin1 i u j I ltac:(rewrite Pos2Nat.inj_1; exact J)) as M. apply tree_numbers_spec in M. rewrite mem_empty in M. destruct M; [discriminate|assumption].
    - destruct (B2 i u I) as (j & p & c & J & E & Er & _). exists j, p, c. split; [exact E|]. split; [exact Er|].
      pose proof (all_in_spec _ _ _ _ Hin2 i u j I J) as M. apply tree_numbers_spec in M. rewrite mem_empty in M. destruct M; [discriminate|assumption]. }
  assert (table_vertex : forall j p, find j m = Some (p, AtVertex) -> place K j = real p).
  { intros j p E. destruct (B3 j p AtVertex E) as [E1|(Ne & _)]; [|contradiction].
    destruct (A4 j p AtVertex E1) as [E0|(i & v & I & J & _ & Er & _)]; [rewrite PositiveMap.gempty in E0; discriminate|].
    unfold place. replace (Pos.to_nat j - 1)%nat with i by lia. rewrite (nth_error_nth _ _ _ I). auto. }
  assert (segs : forall j s, find j sm = Some s -> segment_fine m j s).
  { intros j s E. destruct (S2 j s E) as [E0|[_ F]]; [rewrite PositiveMap.gempty in E0; discriminate|exact F]. }
  split; [|split].
  - intros p I. apply (all_vertices V T D). unfold V, all_points. apply in_or_app. left. apply in_map. exact I.
  - intros a b x I Hx. destruct (S3 tr g (used sm t (c_facets K)) Hseg a b I) as (j & s & Fj & Ea & Eb & W).
    destruct (segs j s Fj) as (Va & Vb & Dp & Ch).
    pose proof (vertex_place K m table_vertex _ Va) as Pa. pose proof (vertex_place K m table_vertex _ Vb) as Pb. rewrite Ea in Pa. rewrite Eb in Pb.
    pose proof (distinct_sound V m table_in _ _ Dp) as Ne.
    rewrite <- Pa, <- Pb in *. rewrite <- Ea, <- Eb in *.
    destruct (chain_covers V m table_in j _ _ _ Ch x Hx) as (e & Ie & Hxe).
    destruct (chain_pieces V m table_in j _ _ _ Ch Ne e Ie) as [_ Sub].
    exists (at_ m (fst e)), (at_ m (snd e)). split; [|split; [exact Hxe|exact Sub]].
    destruct W as [W|W].
    + apply used_spec in W. destruct W as (F & e0 & h & d & IF & Ie0 & Sb).
      destruct (segment_between_spec _ _ _ _ _ _ _ Sb) as (Fj' & _ & _). rewrite Fj in Fj'. injection Fj'; intros; subst h.
      destruct (facets_ok_spec m sm t tr g _ _ _ Hfac F IF) as (k' & cs & Hf). destruct (facet_ok_spec m sm t tr g _ _ _ Hf) as (x' & C1 & C2 & C3 & C4).
      eapply (facet_edges K V m sm t tr g T); eauto.
    + eapply (hanging_links V m tr g T); eauto.
  - intros F x IF Hx. destruct (facets_ok_spec m sm t tr g _ _ _ Hfac F IF) as (k' & cs & Hf). destruct (facet_ok_spec m sm t tr g _ _ _ Hf) as (x' & C1 & C2 & C3 & C4).
    eapply (facet_union K V m sm t tr g T); eauto.
Qed.

(** If the check accepts certificate C for complex K, then K conforms to EVERY Delaunay subdivision of the points. *)
Theorem check_sound : forall K C, check K C = true -> forall T, delaunay (all_points K C) T -> conforms K T.
Proof.
  intros K C H T D. apply (check_covering K C H). apply (subdivision_covering solid); [intros; left; assumption|exact D].
Qed.
(** The same in a plane: if all points lie in one plane, the subdivisions are into triangles. *)
Theorem check_sound_planar : forall K C, check K C = true -> forall T, delaunay_planar (all_points K C) T -> conforms K T.
Proof.
  intros K C H T D. apply (check_covering K C H). apply (subdivision_covering flat); [intros; right; assumption|exact D].
Qed.
