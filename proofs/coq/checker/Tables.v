(* SPDX-License-Identifier: Apache-2.0 *)
(** * What the tables, the tree and the sets of edges contain *)
From Coq Require Import ZArith Arith List Bool Lia Reals Lra Permutation FMapPositive.
From Confidel.checker Require Import Space Statement Planar Crossing Walk Region Check Arithmetic.
Import ListNotations.

Notation find := PositiveMap.find.
Lemma find_add {A} k j (x : A) m : find j (PositiveMap.add k x m) = if Pos.eqb j k then Some x else find j m.
Proof. destruct (Pos.eqb_spec j k) as [->|N]; [apply PositiveMap.gss|apply PositiveMap.gso; exact N]. Qed.
Lemma mem_insert k j s : mem j (insert k s) = true <-> j = k \/ mem j s = true.
Proof. unfold mem, insert. rewrite find_add. destruct (Pos.eqb_spec j k); split; intros; auto; destruct H; auto; contradiction. Qed.
Lemma mem_empty j : mem j (PositiveMap.empty unit) = false.
Proof. unfold mem. rewrite PositiveMap.gempty. reflexivity. Qed.
Lemma number_eqb_spec a b : number_eqb a b = true <-> a = b.
Proof. apply Pos.eqb_eq. Qed.

(** ** Points *)
Lemma load_vertices_spec : forall l ws k m k' ws' m', load_vertices l ws k m = Some (k', ws', m') ->
  (Pos.to_nat k' = Pos.to_nat k + length l)%nat /\
  (forall j, (Pos.to_nat j < Pos.to_nat k)%nat -> find j m' = find j m) /\
  (forall i v, nth_error l i = Some v -> exists j q, (Pos.to_nat j = Pos.to_nat k + i)%nat /\ find j m' = Some (q, AtVertex) /\ real q = real v /\ (0 < hw q)%Z) /\
  (forall j q c, find j m' = Some (q, c) -> find j m = Some (q, c) \/
     exists i v, nth_error l i = Some v /\ (Pos.to_nat j = Pos.to_nat k + i)%nat /\ c = AtVertex /\ real q = real v /\ (0 < hw q)%Z).
Proof.
  induction l as [|v l IH]; intros ws k m k' ws' m' H; cbn [load_vertices] in H.
  - injection H; intros; subst. simpl. split; [lia|]. repeat split; auto. intros [|i] ? E; discriminate.
  - destruct ws as [|q ws]; [discriminate|]. destruct (same_point v q) eqn:Same; [|discriminate].
    destruct (same_point_sound _ _ Same) as (Er & _ & Q). destruct (IH _ _ _ _ _ _ H) as (A & B & C & D). rewrite Pos2Nat.inj_succ in *.
    split; [simpl; lia|]. split; [|split].
    + intros j Hj. rewrite B by lia. rewrite find_add. destruct (Pos.eqb_spec j k); [subst; lia|reflexivity].
    + intros [|i] u E; simpl in E.
      * injection E; intros; subst u. exists k, q. split; [lia|]. rewrite B by lia. rewrite find_add, Pos.eqb_refl. auto.
      * destruct (C i u E) as (j & p & J & K). exists j, p. split; [lia|exact K].
    + intros j p c E. destruct (D j p c E) as [E1|(i & u & E1 & J & K)].
      * rewrite find_add in E1. destruct (Pos.eqb_spec j k); [|left; exact E1]. injection E1; intros; subst. right. exists 0%nat, v. split; [reflexivity|]. split; [lia|auto].
      * right. exists (Datatypes.S i), u. split; [exact E1|]. split; [lia|exact K].
Qed.
Lemma load_steiner_spec : forall l ws k m k' m', load_steiner l ws k m = Some (k', m') ->
  (forall j, (Pos.to_nat j < Pos.to_nat k)%nat -> find j m' = find j m) /\
  (forall i v, nth_error l i = Some v -> exists j q c, (Pos.to_nat j = Pos.to_nat k + i)%nat /\ find j m' = Some (q, c) /\ real q = real (fst v) /\ (0 < hw q)%Z) /\
  (forall j q c, find j m' = Some (q, c) -> find j m = Some (q, c) \/
     c <> AtVertex /\ exists v, In v l /\ real q = real (fst v) /\ (0 < hw q)%Z).
Proof.
  induction l as [|[v d] l IH]; intros ws k m k' m' H; cbn [load_steiner] in H.
  - destruct ws; [|discriminate]. injection H; intros; subst. repeat split; auto. intros [|i] ? E; discriminate.
  - destruct ws as [|q ws]; [discriminate|]. destruct (same_point v q && is_steiner d) eqn:Same; [|discriminate]. apply andb_true_iff in Same. destruct Same as [Same St].
    destruct (same_point_sound _ _ Same) as (Er & _ & Q). destruct (IH _ _ _ _ _ H) as (B & C & D). rewrite Pos2Nat.inj_succ in *.
    split; [|split].
    + intros j Hj. rewrite B by lia. rewrite find_add. destruct (Pos.eqb_spec j k); [subst; lia|reflexivity].
    + intros [|i] u E; simpl in E.
      * injection E; intros; subst u. exists k, q, d. split; [lia|]. rewrite B by lia. rewrite find_add, Pos.eqb_refl. auto.
      * destruct (C i u E) as (j & p & c & J & K). exists j, p, c. split; [lia|exact K].
    + intros j p c E. destruct (D j p c E) as [E1|(N & u & I & K)].
      * rewrite find_add in E1. destruct (Pos.eqb_spec j k); [|left; exact E1]. injection E1; intros; subst. right. split; [intros ->; discriminate|].
        exists (v, c). split; [left; reflexivity|auto].
      * right. split; [exact N|]. exists u. split; [right; exact I|exact K].
Qed.
Lemma all_in_spec : forall A (l : list A) k s, all_in l k s = true -> forall i v j, nth_error l i = Some v -> (Pos.to_nat j = Pos.to_nat k + i)%nat -> mem j s = true.
Proof.
  induction l as [|x l IH]; intros k s H [|i] v j E J; try discriminate; cbn [all_in] in H; apply andb_true_iff in H; destruct H as [H1 H2].
  - replace j with k by lia. exact H1.
  - apply (IH _ _ H2 i v); auto. rewrite Pos2Nat.inj_succ. lia.
Qed.

(** ** The tree *)
Inductive in_tree (k : number) : tree -> Prop :=
| in_leaf b l : In k l -> in_tree k (Leaf b l)
| in_left b t u : in_tree k t -> in_tree k (Node b t u)
| in_right b t u : in_tree k u -> in_tree k (Node b t u).
Lemma tree_numbers_spec k : forall t s, mem k (tree_numbers t s) = true -> mem k s = true \/ in_tree k t.
Proof.
  induction t as [b l|b t IHt u IHu]; intros s H; cbn [tree_numbers] in H.
  - revert s H. assert (G : forall l0 s, incl l0 l -> mem k (fold_left (fun s k => insert k s) l0 s) = true -> mem k s = true \/ in_tree k (Leaf b l)).
    { induction l0 as [|x l0 IH]; intros s I H; [auto|]. simpl in H. apply IH in H; [|intros y Y; apply I; right; exact Y].
      destruct H as [H|H]; [|auto]. apply mem_insert in H. destruct H as [->|H]; [right; constructor; apply I; left; reflexivity|auto]. }
    intros s H. apply (G l s (incl_refl _) H).
  - apply IHu in H. destruct H as [H|H]; [|right; apply in_right; exact H]. apply IHt in H. destruct H; [auto|right; apply in_left; assumption].
Qed.
Section Tree.
Variables (m : points) (g : Z).
Hypothesis pos_w : forall k p c, find k m = Some (p, c) -> (0 < hw p)%Z.
Lemma tree_ok_spec : forall t, tree_ok m g t = true -> forall k, in_tree k t -> exists p c, find k m = Some (p, c) /\ in_box g (box_of t) (real p).
Proof.
  induction t as [b l|b t IHt u IHu]; intros H k I; cbn [tree_ok] in H; inversion I; subst; cbn [box_of].
  - rewrite forallb_forall in H. specialize (H k H1). destruct (find k m) as [[p c]|] eqn:E; [|discriminate]. exists p, c. split; [reflexivity|].
    apply point_in_box_sound; eauto.
  - bools. destruct (IHt ltac:(assumption) k ltac:(assumption)) as (p & c & E & B). exists p, c. split; [exact E|]. apply (box_in_box_sound g b (box_of t)); assumption.
  - bools. destruct (IHu ltac:(assumption) k ltac:(assumption)) as (p & c & E & B). exists p, c. split; [exact E|]. apply (box_in_box_sound g b (box_of u)); assumption.
Qed.
Lemma query_spec f q : forall t, tree_ok m g t = true -> query f q t = true -> forall k p c, in_tree k t -> find k m = Some (p, c) -> in_box g q (real p) -> f k = true.
Proof.
  induction t as [b l|b t IHt u IHu]; intros H Q k p c I E B; pose proof (tree_ok_spec _ H k I) as (p' & c' & E' & B'); rewrite E in E'; injection E'; intros; subst p' c';
    cbn [query] in Q; destruct (apart q _) eqn:A; try (exfalso; eapply apart_sound; eauto; fail); inversion I; subst; cbn [tree_ok] in H.
  - rewrite forallb_forall in Q. auto.
  - bools. eapply IHt; eauto.
  - bools. eapply IHu; eauto.
Qed.
End Tree.

(** ** Segments *)
Fixpoint links (a : number) (ms : list number) (b : number) : list edge :=
  match ms with [] => [(a, b)] | k :: ms' => (a, k) :: links k ms' b end.
Lemma fold_links_spec {A} (f : A -> edge -> A) : forall ms a b x, fold_links f a ms b x = fold_left f (links a ms b) x.
Proof. induction ms as [|k ms IH]; intros; simpl; auto. Qed.
Lemma all_links_spec f : forall ms a b, all_links f a ms b = forallb f (links a ms b).
Proof. induction ms as [|k ms IH]; intros; simpl; [rewrite andb_true_r; reflexivity|rewrite IH; reflexivity]. Qed.

Section Segments.
Variable m : points.
Definition segment_fine s g := is_vertex m (g_a g) = true /\ is_vertex m (g_b g) = true /\ distinct_places m (g_a g) (g_b g) = true /\ chain_ok m s (g_a g) (g_ms g) (g_b g) = true.
Lemma load_segments_spec : forall l ws k sm sm', load_segments m l ws k sm = Some sm' ->
  (forall j, (j < k)%positive -> find j sm' = find j sm) /\
  (forall j g, find j sm' = Some g -> find j sm = Some g \/ In (g_a g, g_b g) l /\ segment_fine j g) /\
  (forall tr gg u, segments_ok m tr gg sm' u l k = true -> forall a b, In (a, b) l -> exists j g, find j sm' = Some g /\ g_a g = a /\ g_b g = b /\
     (mem j u = true \/ hanging_ok m tr gg (g_a g) (g_ms g) (g_b g) (g_boxes g) = true)).
Proof.
  induction l as [|[a b] l IH]; intros ws k sm sm' H; cbn [load_segments] in H.
  - destruct ws; [|discriminate]. injection H; intros; subst. repeat split; auto; intros; contradiction.
  - destruct ws as [|[ms bs] ws]; [discriminate|].
    destruct (is_vertex m a && is_vertex m b && distinct_places m a b && chain_ok m k a ms b) eqn:S; [|discriminate]. bools.
    destruct (IH _ _ _ _ H) as (A & B & C).
    assert (F : find k sm' = Some (Segment a b ms bs)) by (rewrite A by lia; rewrite find_add, Pos.eqb_refl; reflexivity).
    split; [|split].
    + intros j J. rewrite A by lia. rewrite find_add. destruct (Pos.eqb_spec j k); [lia|reflexivity].
    + intros j g E. destruct (B j g E) as [E1|[E1 E2]]; [|right; split; [right; exact E1|exact E2]].
      rewrite find_add in E1. destruct (Pos.eqb_spec j k); [|auto]. injection E1; intros; subst. right. split; [left; reflexivity|]. repeat split; assumption.
    + intros tr gg u Q a' b' [E|I]; cbn [segments_ok] in Q; apply andb_true_iff in Q; destruct Q as [Q1 Q2]; [|apply (C tr gg u Q2); exact I].
      injection E; intros; subst a' b'. exists k, (Segment a b ms bs). split; [exact F|]. split; [reflexivity|]. split; [reflexivity|].
      apply orb_true_iff in Q1. destruct Q1 as [Q1|Q1]; [left; exact Q1|right]. rewrite F in Q1. exact Q1.
Qed.
Lemma directed_spec sm t a b k g : directed sm t a b = Some (k, g) -> find k sm = Some g /\ g_a g = a /\ g_b g = b.
Proof.
  unfold directed. destruct (assoc b (get a t)) as [j|]; [|discriminate]. destruct (find j sm) as [h|] eqn:E; [|discriminate].
  destruct (number_eqb a (g_a h) && number_eqb b (g_b h)) eqn:Q; [|discriminate]. apply andb_true_iff in Q. destruct Q as [Q1 Q2]. apply number_eqb_spec in Q1, Q2.
  intro H. injection H; intros; subst. auto.
Qed.
Lemma segment_between_spec sm t a b k g d : segment_between sm t a b = Some (k, g, d) -> find k sm = Some g /\
  directed sm t (g_a g) (g_b g) = Some (k, g) /\ if d then g_a g = a /\ g_b g = b else g_a g = b /\ g_b g = a.
Proof.
  unfold segment_between. destruct (directed sm t a b) as [[j h]|] eqn:E.
  - intro H. injection H; intros; subst. pose proof (directed_spec _ _ _ _ _ _ E) as (E1 & E2 & E3). rewrite E2, E3. auto.
  - destruct (directed sm t b a) as [[j h]|] eqn:E2; [|discriminate]. intro H. injection H; intros; subst.
    pose proof (directed_spec _ _ _ _ _ _ E2) as (E3 & E4 & E5). rewrite E4, E5. auto.
Qed.
End Segments.

(** ** Sets of edges *)
Lemma has_spec s e e' l : add_edge (Some s) e = Some l -> has l e' = true <-> e' = e \/ has s e' = true.
Proof.
  unfold add_edge. destruct (has s e) eqn:H; [discriminate|]. intro E. injection E; intros; subst l. unfold has, get. rewrite find_add.
  destruct e as [a b], e' as [a' b']; cbn [fst snd]. destruct (Pos.eqb_spec a' a) as [->|N].
  - cbn [existsb]. rewrite orb_true_iff, number_eqb_spec. split; intros [K|K]; auto; [left; congruence|left; congruence].
  - split; [auto|]. intros [K|K]; [congruence|exact K].
Qed.
Lemma add_edges_none : forall es, fold_left add_edge es None = None.
Proof. induction es; auto. Qed.
Lemma add_edges_spec : forall es s s', fold_left add_edge es (Some s) = Some s' ->
  (forall e, has s' e = true <-> has s e = true \/ In e es) /\ NoDup es /\ forall e, In e es -> has s e = false.
Proof.
  induction es as [|e es IH]; intros s s' H.
  - simpl in H. injection H; intros; subst. split; [intro; simpl; tauto|]. split; [constructor|intros ? []].
  - cbn [fold_left] in H. destruct (add_edge (Some s) e) as [s1|] eqn:A; [|rewrite add_edges_none in H; discriminate].
    destruct (IH _ _ H) as (B & C & D). pose proof (fun e' => has_spec s e e' s1 A) as Q.
    assert (N : has s e = false) by (unfold add_edge in A; destruct (has s e); [discriminate|reflexivity]).
    split; [|split].
    + intro x. rewrite B, Q. simpl. split; intros K; intuition (subst; auto).
    + constructor; [|exact C]. intro I. specialize (D e I). assert (has s1 e = true) by (apply Q; auto). congruence.
    + intros x [<-|I]; [exact N|]. specialize (D x I). destruct (has s x) eqn:Hx; [|reflexivity]. assert (has s1 x = true) by (apply Q; auto). congruence.
Qed.
Lemma has_empty e : has (PositiveMap.empty _) e = false.
Proof. unfold has, get. rewrite PositiveMap.gempty. reflexivity. Qed.
Definition triple_of (c : cell) : triple := (t_a c, t_b c, t_c c).
Lemma add_cells_spec : forall cs s, fold_left add_cell cs s = fold_left add_edge (flat_map sides (map triple_of cs)) s.
Proof. induction cs as [|c cs IH]; intro s; [reflexivity|]. cbn [fold_left map flat_map]. rewrite IH, fold_left_app. reflexivity. Qed.
Definition boundary_links sm t (e : edge) : list edge :=
  match segment_between sm t (fst e) (snd e) with
  | Some (_, g, true) => links (g_a g) (g_ms g) (g_b g)
  | Some (_, g, false) => map swap (links (g_a g) (g_ms g) (g_b g))
  | None => [] end.
Lemma fold_left_map {A B C} (f : A -> B -> A) (h : C -> B) : forall l x, fold_left (fun x c => f x (h c)) l x = fold_left f (map h l) x.
Proof. induction l; simpl; auto. Qed.
Lemma add_boundary_none sm t : forall es, fold_left (add_boundary sm t) es None = None.
Proof.
  induction es as [|e es IH]; [reflexivity|]. simpl. unfold add_boundary at 2. destruct (segment_between sm t (fst e) (snd e)) as [[[k g] [|]]|]; auto.
  - rewrite fold_links_spec, add_edges_none. exact IH.
  - rewrite fold_links_spec, (fold_left_map add_edge swap), add_edges_none. exact IH.
Qed.
Lemma add_boundary_spec sm t : forall es s s', fold_left (add_boundary sm t) es (Some s) = Some s' ->
  fold_left add_edge (flat_map (boundary_links sm t) es) (Some s) = Some s' /\ forall e, In e es -> segment_between sm t (fst e) (snd e) <> None.
Proof.
  induction es as [|e es IH]; intros s s' H; [split; [exact H|intros ? []]|].
  cbn [fold_left flat_map] in *. rewrite fold_left_app.
  assert (E : add_boundary sm t (Some s) e = fold_left add_edge (boundary_links sm t e) (Some s) /\ segment_between sm t (fst e) (snd e) <> None \/ add_boundary sm t (Some s) e = None).
  { unfold add_boundary, boundary_links. destruct (segment_between sm t (fst e) (snd e)) as [[[k g] [|]]|]; [left|left|right; reflexivity]; (split; [|discriminate]).
    - apply fold_links_spec.
    - rewrite fold_links_spec, (fold_left_map add_edge swap). reflexivity. }
  destruct E as [[E1 E2]|E]; [|rewrite E, add_boundary_none in H; discriminate].
  rewrite E1 in H. destruct (fold_left add_edge (boundary_links sm t e) (Some s)) as [s1|]; [|rewrite add_boundary_none in H; discriminate].
  destruct (IH _ _ H) as [I1 I2]. split; [exact I1|]. intros x [<-|X]; auto.
Qed.

Lemma NoDup_app_iff_ {A} (l l' : list A) : NoDup (l ++ l') <-> NoDup l /\ NoDup l' /\ forall x, In x l -> In x l' -> False.
Proof.
  induction l as [|a l IH]; simpl.
  - split; [intro; split; [constructor|split; [assumption|intros ? []]]|tauto].
  - split.
    + intro H. inversion H; subst. apply IH in H3. destruct H3 as (A1 & A2 & A3). split; [constructor; [intro; apply H2, in_or_app; auto|exact A1]|].
      split; [exact A2|]. intros x [<-|X] Y; [apply H2, in_or_app; auto|eauto].
    + intros (H & H' & D). inversion H; subst. constructor; [|apply IH; split; [assumption|split; [assumption|eauto]]].
      intro I. apply in_app_or in I. destruct I; [contradiction|apply (D a); auto].
Qed.

(** Edges that cancel, but for those of the boundary: equal sums. *)
Lemma swap_swap e : swap (swap e) = e.
Proof. destruct e; reflexivity. Qed.
Lemma sum_perm {A} (f : A -> Z) l l' : Permutation l l' -> sum f l = sum f l'.
Proof. induction 1; simpl in *; lia. Qed.
Lemma sum_swap f l : (forall e, f (swap e) = (- f e)%Z) -> sum f (map swap l) = (- sum f l)%Z.
Proof. intro H. induction l; simpl; [reflexivity|]. unfold sum in *. rewrite IHl, H. lia. Qed.
Lemma cancel (E B : list edge) : NoDup E -> NoDup B -> (forall e, In e B -> In e E) ->
  (forall e, In e E -> In (swap e) E /\ ~ In e B \/ ~ In (swap e) E /\ In e B) ->
  forall f, (forall e, f (swap e) = (- f e)%Z) -> sum f E = sum f B.
Proof.
  intros NE NB BE X f A. set (L := E ++ map swap B).
  assert (inj : forall l, NoDup l -> NoDup (map swap l)).
  { intros l N. apply FinFun.Injective_map_NoDup; [|exact N]. intros x y H. rewrite <- (swap_swap x), H, swap_swap. reflexivity. }
  assert (mid : forall e, In e (map swap B) <-> In (swap e) B).
  { intro e. rewrite in_map_iff. split; [intros (x & <- & H); rewrite swap_swap; exact H|intro H; exists (swap e); split; [apply swap_swap|exact H]]. }
  assert (NL : NoDup L).
  { unfold L. apply NoDup_app_iff_. split; [exact NE|]. split; [apply inj; exact NB|].
    intros e H1 H2. apply mid in H2. pose proof (BE _ H2) as H3. destruct (X _ H3) as [[_ H4]|[H4 _]]; [contradiction|]. rewrite swap_swap in H4. contradiction. }
  assert (P : Permutation L (map swap L)).
  { apply NoDup_Permutation; [exact NL|apply inj; exact NL|]. 
    assert (C : forall e, In e L -> In (swap e) L).
    { intros e H. unfold L in *. apply in_app_or in H. apply in_or_app. destruct H as [H|H].
      - destruct (X e H) as [[H1 _]|[_ H1]]; [left; exact H1|right; apply mid; rewrite swap_swap; exact H1].
      - left. apply BE. apply mid. exact H. }
    intro e. rewrite in_map_iff. split.
    - intro H. exists (swap e). split; [apply swap_swap|apply C; exact H].
    - intros (x & <- & H). apply C. exact H. }
  pose proof (sum_perm f _ _ P) as S. rewrite (sum_swap f L A) in S. unfold L in S. rewrite sum_app, (sum_swap f B A) in S. lia.
Qed.
