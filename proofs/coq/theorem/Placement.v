(** The placement of theory.md section 3, (1)-(6): where points may lie, and the cells
    T, S, R, C with their diametral spheres (centre and one corner).

    A point is described by its carrier, the simplex of K on which it was placed. What
    the emptiness proof needs to know of it is [placed]:
    - on an edge: at distance >= r cos beta from both ends (m and the row between);
    - on a face: outside the open balls of radius r at the corners and at distance
      >= d from the lines of the edges (protectors, arc points, Chew points). *)
From Coq Require Import Reals Lra Psatz List.
From Confidel.lemmas Require Import Space Margins.
From Confidel.theorem Require Import Complex.
Import ListNotations.
Open Scope R_scope.

(** Step (1)-(4): r = delta/3, beta = phi/3, d = r sin beta, h at most
    min(2 r sin(phi/12), (2/3) d_f) with d_f = 2 d sin(alpha/2). *)
Record setting (r phi beta d h alpha : R) : Prop := {
  set_parameters : parameters r phi beta d h;
  set_alpha : 0 <= alpha <= PI;
  set_gap : 3 / 2 * h <= 2 * d * sin (alpha / 2)
}.

Definition same_tri (a b c p q s : vec) :=
  (p = a /\ q = b /\ s = c) \/ (p = b /\ q = c /\ s = a) \/ (p = c /\ q = a /\ s = b) \/
  (p = b /\ q = a /\ s = c) \/ (p = a /\ q = c /\ s = b) \/ (p = c /\ q = b /\ s = a).

Definition placed r beta d s x :=
  match s with
  | Pt v => x = v
  | Seg v w => exists k, r * cos beta <= k <= dist v w - r * cos beta /\ x = vadd v (vscale k (dir v w))
  | Tri a b c => in_simplex (Tri a b c) x /\
      forall p q t, same_tri a b c p q t ->
        r <= dist p x /\ d <= dot (offset p q t) (vsub x p)
  end.

(** Angle of the face v w z at v. *)
Definition corner_angle v w z theta :=
  0 < theta < PI /\
  vsub z v = vscale (dist v z) (vadd (vscale (cos theta) (dir v w)) (vscale (sin theta) (offset v w z))).

(** The vector from v to the point of the face on its protecting circle at angle t from vw. *)
Definition arc_vec r v w z t := vadd (vscale (r * cos t) (dir v w)) (vscale (r * sin t) (offset v w z)).

(** The cells. [cell ... v w z c p]: a cell of face v w z whose diametral sphere is centred
    at c and passes through p. *)
Inductive T_cell K r beta d : vec -> vec -> vec -> vec -> vec -> Prop :=
  T_intro v w z : has K (Tri v w z) ->
    let a := vadd (vscale (r * cos beta) (dir v w)) (vscale d (offset v w z)) in
    T_cell K r beta d v w z (vadd v (vscale (1 / 2) a)) (vadd v vzero).

Inductive S_cell K r beta h : vec -> vec -> vec -> R -> R -> vec -> vec -> Prop :=
  S_intro v w z theta t1 t2 : has K (Tri v w z) -> corner_angle v w z theta ->
    beta <= t1 -> t1 < t2 -> t2 <= theta - beta -> 2 * r * sin ((t2 - t1) / 2) <= 3 / 2 * h ->
    let b := arc_vec 1 v w z ((t1 + t2) / 2) in
    S_cell K r beta h v w z t1 t2 (vadd v (vscale (r / (2 * cos ((t2 - t1) / 2))) b)) (vadd v vzero).

Inductive R_cell K r beta d h : vec -> vec -> vec -> R -> R -> vec -> vec -> Prop :=
  R_intro v w z x1 x2 : has K (Tri v w z) ->
    r * cos beta <= x1 -> x1 < x2 -> x2 <= dist v w - r * cos beta -> x2 - x1 <= 3 / 2 * h ->
    let u := dir v w in
    R_cell K r beta d h v w z x1 x2
      (vadd v (vadd (vscale ((x1 + x2) / 2) u) (vscale (d / 2) (offset v w z)))) (vadd v (vscale x1 u)).

(** The plane of a face, and C: a corner p placed on the face, centre in the plane,
    circumradius at most h. *)
Definition plane_of v w z x := exists X Y, vsub x v = vadd (vscale X (dir v w)) (vscale Y (offset v w z)).

Inductive C_cell K r beta d h : vec -> vec -> vec -> vec -> vec -> Prop :=
  C_intro v w z c p : has K (Tri v w z) -> placed r beta d (Tri v w z) p ->
    (forall v' w' z', same_tri v w z v' w' z' -> plane_of v' w' z' c) -> dist c p <= h ->
    C_cell K r beta d h v w z c p.

(** ** Permutations and corners *)

Lemma same_tri_has K a b c p q s : same_tri a b c p q s -> has K (Tri a b c) -> has K (Tri p q s).
Proof. unfold same_tri. simpl. intros H ?. repeat destruct H as [H|H]; destruct H as (-> & -> & ->); tauto. Qed.

Lemma same_tri_in a b c p q s v : same_tri a b c p q s -> (In v [p; q; s] <-> In v [a; b; c]).
Proof.
  unfold same_tri. simpl. intros H. repeat destruct H as [H|H]; destruct H as (-> & -> & ->); tauto.
Qed.

Lemma same_tri_trans a b c p q s x y z : same_tri a b c p q s -> same_tri p q s x y z -> same_tri a b c x y z.
Proof.
  unfold same_tri. intros H G.
  repeat destruct H as [H|H]; destruct H as (-> & -> & ->);
  repeat destruct G as [G|G]; destruct G as (-> & -> & ->); tauto.
Qed.

Lemma in_simplex_perm a b c p q s x : same_tri a b c p q s -> in_simplex (Tri a b c) x -> in_simplex (Tri p q s) x.
Proof.
  unfold same_tri. intros H (i & j & k & Hi & Hj & Hk & S & ->).
  assert (E : forall u v w x y t, bary3 u v w x y t = bary3 v u w y x t) by (unfold bary3; veq).
  assert (G : forall u v w x y t, bary3 u v w x y t = bary3 v w u y t x) by (unfold bary3; veq).
  destruct H as [H|[H|[H|[H|[H|H]]]]]; destruct H as (-> & -> & ->).
  - exists i, j, k. repeat split; try assumption; lra.
  - exists j, k, i. repeat split; try assumption; try lra. apply G.
  - exists k, i, j. repeat split; try assumption; try lra. rewrite G. apply G.
  - exists j, i, k. repeat split; try assumption; try lra. apply E.
  - exists i, k, j. repeat split; try assumption; try lra. rewrite G. rewrite E. rewrite G. apply G.
  - exists k, j, i. repeat split; try assumption; try lra. rewrite G. apply E.
Qed.

Lemma placed_perm r beta d a b c p q s x : same_tri a b c p q s ->
  placed r beta d (Tri a b c) x -> placed r beta d (Tri p q s) x.
Proof.
  intros H [I P]. split; [eapply in_simplex_perm; eassumption|].
  intros p' q' s' G. apply P. eapply same_tri_trans; eassumption.
Qed.

Lemma placed_seg_sym r beta d v w x : v <> w -> placed r beta d (Seg v w) x -> placed r beta d (Seg w v) x.
Proof.
  intros N (k & Hk & ->). exists (dist v w - k). rewrite (dist_sym w v). split; [lra|].
  rewrite (dir_opposite v w). pose proof (dir_scale v w N) as E.
  set (u := dir v w) in *. set (L := dist v w) in *. clearbody u L.
  assert (W : w = vadd v (vscale L u)).
  { rewrite <- E. generalize v w. intros. apply vec_eq; unfold vadd, vsub; simpl; ring. }
  rewrite W. generalize v u. intros. apply vec_eq; unfold vadd, vscale; simpl; ring.
Qed.

Lemma placed_in_simplex K r phi alpha beta d s x : simplicial K -> has K s -> 0 <= r * cos beta ->
  features K r phi alpha -> placed r beta d s x -> in_simplex s x.
Proof.
  intros S H B F P. destruct s as [v|v w|a b c]; simpl in P; [exact P| |apply P].
  destruct P as (k & Hk & ->). pose proof (proper_seg K S v w H) as N.
  assert (L : 0 < dist v w).
  { rewrite dist_sym. apply norm_pos. intros Z. apply N. destruct v, w.
    unfold vsub, vzero in Z; simpl in Z. injection Z. intros. f_equal; lra. }
  exists (k / dist v w).
  assert (E : k / dist v w * dist v w = k) by (field; lra).
  split; [set (q := k / dist v w) in *; nra|].
  unfold along. rewrite (dir_scale v w N). set (q := k / dist v w) in *. rewrite <- E.
  generalize (dir v w) (dist v w) q v. intros. apply vec_eq; unfold vadd, vscale; simpl; ring.
Qed.

(** A carrier that has the corner v, brought into a form that starts with v. *)
Lemma carrier_at K r beta d t x v : simplicial K -> has K t -> placed r beta d t x -> In v (corners t) ->
  (t = Pt v /\ x = v)
  \/ (exists w', has K (Seg v w') /\ placed r beta d (Seg v w') x /\
        forall c, In c [v; w'] <-> In c (corners t))
  \/ (exists p q, has K (Tri v p q) /\ placed r beta d (Tri v p q) x /\
        forall c, In c [v; p; q] <-> In c (corners t)).
Proof.
  intros S H P I. destruct t as [a|a b|a b c]; simpl in I.
  - left. simpl in P. destruct I as [<-|[]]. split; [reflexivity|exact P].
  - right; left. destruct I as [<-|[<-|[]]].
    + exists b. split; [exact H|]. split; [exact P|]. intros x0. tauto.
    + exists a. split; [apply has_seg_sym, H|]. split; [apply placed_seg_sym; [apply (proper_seg K S), H|exact P]|].
      intros c. simpl. tauto.
  - right; right. destruct I as [<-|[<-|[<-|[]]]].
    + exists b, c. split; [exact H|]. split; [exact P|]. intros x0. tauto.
    + exists c, a. assert (G : same_tri a b c b c a) by (unfold same_tri; tauto).
      split; [eapply same_tri_has; eassumption|]. split; [eapply placed_perm; eassumption|].
      intros x0. apply same_tri_in. exact G.
    + exists a, b. assert (G : same_tri a b c c a b) by (unfold same_tri; tauto).
      split; [eapply same_tri_has; eassumption|]. split; [eapply placed_perm; eassumption|].
      intros x0. apply same_tri_in. exact G.
Qed.
