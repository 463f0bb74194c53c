(** The input: a finite 2-dimensional simplicial complex K in space, and the three
    numbers of theory.md section 3 that are measured on it: delta (as 3r), the link
    angle phi and the dihedral angle alpha. *)
From Coq Require Import Reals Lra Psatz List.
From Confidel.lemmas Require Import Space.
Import ListNotations.
Open Scope R_scope.

Inductive simplex := Pt (v : vec) | Seg (v w : vec) | Tri (a b c : vec).
Definition corners s := match s with Pt v => [v] | Seg v w => [v; w] | Tri a b c => [a; b; c] end.

(** A complex is a finite list of simplices; the order of corners does not matter. *)
Definition complex := list simplex.
Definition has (K : complex) s :=
  match s with
  | Pt v => In (Pt v) K
  | Seg v w => In (Seg v w) K \/ In (Seg w v) K
  | Tri a b c => In (Tri a b c) K \/ In (Tri b c a) K \/ In (Tri c a b) K
              \/ In (Tri b a c) K \/ In (Tri a c b) K \/ In (Tri c b a) K
  end.

(** The points of a simplex. *)
Definition bary3 a b c i j k := vadd (vscale i a) (vadd (vscale j b) (vscale k c)).
Definition in_simplex s x :=
  match s with
  | Pt v => x = v
  | Seg v w => on_segment v w x
  | Tri a b c => exists i j k, 0 <= i /\ 0 <= j /\ 0 <= k /\ i + j + k = 1 /\ x = bary3 a b c i j k
  end.

(** The vectors that point from v into the simplex (a ray or a plane sector). *)
Definition sector v s y :=
  match s with
  | Pt a => exists i, 0 <= i /\ y = vscale i (vsub a v)
  | Seg a b => exists i j, 0 <= i /\ 0 <= j /\ y = vadd (vscale i (vsub a v)) (vscale j (vsub b v))
  | Tri a b c => exists i j k, 0 <= i /\ 0 <= j /\ 0 <= k /\
      y = vadd (vscale i (vsub a v)) (vadd (vscale j (vsub b v)) (vscale k (vsub c v)))
  end.

(** K is a simplicial complex: closed under faces, non-degenerate, and two simplices
    meet in the simplex on their common corners or not at all. *)
Definition disjoint s t := forall v, In v (corners s) -> ~ In v (corners t).
Definition meet_only_at v s t :=
  In v (corners s) /\ In v (corners t) /\ forall w, In w (corners s) -> In w (corners t) -> w = v.

Record simplicial (K : complex) : Prop := {
  closed_seg : forall a b c, has K (Tri a b c) -> has K (Seg a b);
  closed_pt : forall a b, has K (Seg a b) -> has K (Pt a);
  proper_seg : forall a b, has K (Seg a b) -> a <> b;
  proper_tri : forall a b c, has K (Tri a b c) -> cross (vsub b a) (vsub c a) <> vzero;
  meets_in_face : forall s t x, has K s -> has K t -> in_simplex s x -> in_simplex t x ->
    exists f, has K f /\ incl (corners f) (corners s) /\ incl (corners f) (corners t) /\ in_simplex f x
}.

(** Unit direction of an edge, and the unit offset direction of a face at an edge: in
    the plane of the face, orthogonal to the edge, on the side of the third corner. *)
Definition unit v := vscale (/ norm v) v.
Definition dir v w := unit (vsub w v).
Definition across u y := vsub y (vscale (dot y u) u).
Definition offset v w z := unit (across (dir v w) (vsub z v)).

(** r, phi, alpha are admissible for K:
    - simplices without a common corner are at least 3r apart (delta >= 3r);
    - simplices with one common corner v make at least the angle phi there. For edge-edge
      and edge-face pairs this is theory.md's phi*; face-face pairs are asked for too
      (they are never the minimum: goal 1 of Remaining.v);
    - faces at a common edge make at least the dihedral angle alpha. *)
Record features (K : complex) (r phi alpha : R) : Prop := {
  feature_distance : forall s t x y, has K s -> has K t -> disjoint s t ->
    in_simplex s x -> in_simplex t y -> 3 * r <= dist x y;
  feature_link : forall v s t x y, has K s -> has K t -> meet_only_at v s t ->
    sector v s x -> sector v t y -> dot x y <= norm x * norm y * cos phi;
  feature_dihedral : forall v w z z', has K (Tri v w z) -> has K (Tri v w z') -> z <> z' ->
    dot (offset v w z) (offset v w z') <= cos alpha
}.

(** ** First facts *)

Lemma has_seg_sym K v w : has K (Seg v w) -> has K (Seg w v).
Proof. simpl. tauto. Qed.
Lemma has_tri_swap K a b c : has K (Tri a b c) -> has K (Tri b a c).
Proof. simpl. tauto. Qed.
Lemma has_tri_cycle K a b c : has K (Tri a b c) -> has K (Tri b c a).
Proof. simpl. tauto. Qed.

Lemma unit_norm2 v : v <> vzero -> norm2 (unit v) = 1.
Proof.
  intros H. unfold unit. pose proof (norm_pos v H) as P.
  replace (norm2 (vscale (/ norm v) v)) with (/ norm v * / norm v * norm2 v) by vring.
  rewrite <- norm_sqr. field. lra.
Qed.
Lemma unit_scale v : v <> vzero -> v = vscale (norm v) (unit v).
Proof.
  intros H. unfold unit. pose proof (norm_pos v H). destruct v as [x y z].
  set (n := norm (Vec x y z)) in *. apply vec_eq; unfold vscale; simpl; field; lra.
Qed.

Lemma dir_norm2 v w : v <> w -> norm2 (dir v w) = 1.
Proof.
  intros H. apply unit_norm2. intros Z. apply H.
  destruct v, w. unfold vsub, vzero in Z; simpl in Z. injection Z. intros. f_equal; lra.
Qed.
Lemma dir_scale v w : v <> w -> vsub w v = vscale (dist v w) (dir v w).
Proof.
  intros H. unfold dir. rewrite dist_sym. unfold dist. apply unit_scale. intros Z. apply H.
  destruct v, w. unfold vsub, vzero in Z; simpl in Z. injection Z. intros. f_equal; lra.
Qed.
Lemma dir_opposite v w : dir w v = vscale (-1) (dir v w).
Proof.
  unfold dir, unit. assert (E : norm (vsub v w) = norm (vsub w v)) by (apply dist_sym).
  rewrite E. destruct v, w. apply vec_eq; unfold vscale, vsub; simpl; ring.
Qed.

(** The frame (u, o) of a face at an edge. *)
Record frame (v w z u o : vec) (zx zy : R) : Prop := {
  fr_u : norm2 u = 1; fr_o : norm2 o = 1; fr_uo : dot u o = 0;
  fr_w : vsub w v = vscale (dist v w) u;
  fr_z : vsub z v = vadd (vscale zx u) (vscale zy o);
  fr_zy : 0 < zy; fr_w0 : 0 < dist v w
}.

Lemma across_parts u y : norm2 u = 1 -> dot u (across u y) = 0.
Proof. intros U. unfold across. rewrite dot_sub_r, dot_scale_r. unfold norm2 in U. rewrite U, (dot_comm y u). ring. Qed.

Lemma face_frame v w z : cross (vsub w v) (vsub z v) <> vzero ->
  exists zx zy, frame v w z (dir v w) (offset v w z) zx zy.
Proof.
  intros N.
  assert (VW : v <> w).
  { intros ->. apply N. destruct w, z. apply vec_eq; unfold cross, vsub, vzero; simpl; ring. }
  pose proof (dir_norm2 v w VW) as U. set (u := dir v w) in *.
  set (y := vsub z v). set (p := across u y).
  assert (P0 : p <> vzero).
  { intros Z. apply N. pose proof (dir_scale v w VW) as E. fold u in E. rewrite E. fold y.
    assert (Y : y = vscale (dot y u) u).
    { unfold p, across in Z. destruct y as [y1 y2 y3]. destruct (vscale (dot (Vec y1 y2 y3) u) u) as [a b c] eqn:D.
      unfold vsub, vzero in Z; simpl in Z. injection Z. intros. apply vec_eq; simpl; lra. }
    rewrite Y. generalize u (dot y u) (dist v w). intros [? ?] ? ?.
    apply vec_eq; unfold cross, vscale, vzero; simpl; ring. }
  exists (dot y u), (norm p). constructor.
  - exact U.
  - unfold offset. fold u y. apply unit_norm2. exact P0.
  - unfold offset, unit. fold u y. rewrite dot_scale_r. fold p.
    replace (dot u p) with 0; [ring|]. symmetry. apply across_parts. exact U.
  - apply dir_scale. exact VW.
  - unfold offset. fold u y. fold p. rewrite <- unit_scale by exact P0. unfold p, across.
    fold y. generalize y u (dot y u). intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring.
  - apply norm_pos. exact P0.
  - rewrite dist_sym. apply norm_pos. intros Z. apply VW.
    destruct v, w. unfold vsub, vzero in Z; simpl in Z. injection Z. intros. f_equal; lra.
Qed.

(** The frame's vectors are determined by what they satisfy. *)
Lemma unit_of_multiple k o : norm2 o = 1 -> 0 < k -> unit (vscale k o) = o.
Proof.
  intros O K. unfold unit. rewrite norm_scale. unfold norm. rewrite O, sqrt_1, Rabs_pos_eq by lra.
  destruct o. apply vec_eq; unfold vscale; simpl; field; lra.
Qed.
Lemma frame_unique v w z u o zx zy : frame v w z u o zx zy -> dir v w = u /\ offset v w z = o.
Proof.
  intros [U O UO W Z ZY L].
  assert (D : dir v w = u).
  { unfold dir. rewrite W. apply unit_of_multiple; assumption. }
  split; [exact D|]. unfold offset. rewrite D, Z.
  replace (across u (vadd (vscale zx u) (vscale zy o))) with (vscale zy o); [apply unit_of_multiple; assumption|].
  unfold across. rewrite dot_add_l, !dot_scale_l. change (dot u u) with (norm2 u).
  rewrite U, (dot_comm o u), UO. generalize u o. intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring.
Qed.

(** The same face seen from the other end of the edge. *)
Lemma frame_swap v w z u o zx zy : frame v w z u o zx zy ->
  frame w v z (vscale (-1) u) o (dist v w - zx) zy.
Proof.
  intros [U O UO W Z ZY L]. pose proof (dist_sym w v) as S. constructor; try assumption.
  - replace (norm2 (vscale (-1) u)) with (norm2 u) by vring. exact U.
  - rewrite dot_scale_l, UO. ring.
  - rewrite S. replace (vsub v w) with (vscale (-1) (vsub w v)) by (generalize v w; veq).
    rewrite W. generalize u (dist v w). intros. apply vec_eq; unfold vscale; simpl; ring.
  - replace (vsub z w) with (vsub (vsub z v) (vsub w v)) by (generalize z v w; veq).
    rewrite W, Z. generalize u o (dist v w). intros. apply vec_eq; unfold vadd, vsub, vscale; simpl; ring.
  - rewrite S. exact L.
Qed.

Lemma offset_swap K v w z : simplicial K -> has K (Tri v w z) -> offset w v z = offset v w z.
Proof.
  intros S H. destruct (face_frame v w z) as (zx & zy & F); [apply (proper_tri K S), H|].
  apply frame_swap, frame_unique in F. apply F.
Qed.

(** Frame coordinates of a point of the face. *)
Lemma frame_coords v w z u o zx zy x : frame v w z u o zx zy ->
  sector v (Tri v w z) (vsub x v) ->
  exists X Y, 0 <= Y /\ vsub x v = vadd (vscale X u) (vscale Y o).
Proof.
  intros [U O UO W Z ZY L] (i & j & k & Hi & Hj & Hk & E). rewrite W, Z in E.
  exists (j * dist v w + k * zx), (k * zy). split; [apply Rmult_le_pos; lra|].
  rewrite E. replace (vsub v v) with vzero by (generalize v; veq).
  generalize u o (dist v w). intros. apply vec_eq; unfold vadd, vscale, vzero; simpl; ring.
Qed.

Lemma dot_frame u o X Y : norm2 u = 1 -> norm2 o = 1 -> dot u o = 0 ->
  dot u (vadd (vscale X u) (vscale Y o)) = X /\ dot o (vadd (vscale X u) (vscale Y o)) = Y /\
  norm2 (vadd (vscale X u) (vscale Y o)) = X * X + Y * Y.
Proof.
  unfold norm2. intros U O UO. rewrite !dot_add_r, !dot_add_l, !dot_scale_r, !dot_scale_l, (dot_comm o u), U, O, UO.
  repeat split; ring.
Qed.

(** A point of a simplex lies in its sectors. *)
Lemma in_simplex_sector s v x : in_simplex s x -> sector v s (vsub x v).
Proof.
  destruct s as [a|a b|a b c]; simpl.
  - intros ->. exists 1. split; [lra|]. generalize a v. veq.
  - intros (t & Ht & ->). exists (1 - t), t. repeat split; try lra. unfold along. generalize a b v. veq.
  - intros (i & j & k & Hi & Hj & Hk & S & ->). exists i, j, k. repeat split; try assumption.
    assert (E : i = 1 - j - k) by lra. subst i. unfold bary3. generalize a b c v. veq.
Qed.

Lemma power_translate v c p x : power (vadd v c) (vadd v p) x = power c p (vsub x v).
Proof. vring. Qed.
