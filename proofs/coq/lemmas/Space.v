(** Points and vectors of R^3, squared distances, spheres.

    Everything the other files say is said with these few definitions. The plane
    is the case vz = 0. Squared lengths are used wherever a root can be avoided,
    as in theory.md section 6. *)
From Coq Require Import Reals Lra Psatz.
Open Scope R_scope.

Record vec := Vec { vx : R; vy : R; vz : R }.

Definition vzero := Vec 0 0 0.
Definition vadd p q := Vec (vx p + vx q) (vy p + vy q) (vz p + vz q).
Definition vsub p q := Vec (vx p - vx q) (vy p - vy q) (vz p - vz q).
Definition vscale k p := Vec (k * vx p) (k * vy p) (k * vz p).
Definition dot p q := vx p * vx q + vy p * vy q + vz p * vz q.
Definition cross p q :=
  Vec (vy p * vz q - vz p * vy q) (vz p * vx q - vx p * vz q) (vx p * vy q - vy p * vx q).
Definition norm2 p := dot p p.
Definition norm p := sqrt (norm2 p).
Definition dist2 p q := norm2 (vsub p q).
Definition dist p q := norm (vsub p q).

(** [power c a x]: power of x with respect to the sphere centred at c through a;
    negative strictly inside, zero on the sphere, positive outside. *)
Definition power c a x := dist2 c x - dist2 c a.
Definition strictly_inside c a x := power c a x < 0.

(** The point A + t (B - A). *)
Definition along A B t := vadd A (vscale t (vsub B A)).
Definition on_segment A B x := exists t, 0 <= t <= 1 /\ x = along A B t.

Declare Scope vec_scope.
Delimit Scope vec_scope with vec.
Infix "+" := vadd : vec_scope.
Infix "-" := vsub : vec_scope.
Infix "*" := vscale : vec_scope.

(** Expand vectors to coordinates; only for identities of low degree. *)
Ltac vcoords :=
  repeat match goal with v : vec |- _ => destruct v end;
  unfold power, dist2, along, norm2, dot, vadd, vsub, vscale, cross, vzero in *; simpl in *.
Ltac vring := intros; vcoords; ring.

Lemma vec_eq p q : vx p = vx q -> vy p = vy q -> vz p = vz q -> p = q.
Proof. destruct p, q; simpl; intros; subst; reflexivity. Qed.

Ltac veq := intros; apply vec_eq; vcoords; try ring.

Lemma dot_comm p q : dot p q = dot q p. Proof. vring. Qed.
Lemma dot_add_l p q x : dot (vadd p q) x = dot p x + dot q x. Proof. vring. Qed.
Lemma dot_add_r p q x : dot x (vadd p q) = dot x p + dot x q. Proof. vring. Qed.
Lemma dot_sub_l p q x : dot (vsub p q) x = dot p x - dot q x. Proof. vring. Qed.
Lemma dot_sub_r p q x : dot x (vsub p q) = dot x p - dot x q. Proof. vring. Qed.
Lemma dot_scale_l k p x : dot (vscale k p) x = k * dot p x. Proof. vring. Qed.
Lemma dot_scale_r k p x : dot x (vscale k p) = k * dot x p. Proof. vring. Qed.
Lemma dot_zero_l p : dot vzero p = 0. Proof. vring. Qed.
Lemma dot_zero_r p : dot p vzero = 0. Proof. vring. Qed.

(** Push dot products through sums; the remaining products are atoms for lra/nra. *)
Ltac dots := unfold power, dist2, along, norm2 in *;
  repeat rewrite ?dot_add_l, ?dot_add_r, ?dot_sub_l, ?dot_sub_r, ?dot_scale_l, ?dot_scale_r,
                 ?dot_zero_l, ?dot_zero_r in *.

Lemma norm2_nonneg p : 0 <= norm2 p.
Proof. destruct p. unfold norm2, dot; simpl. nra. Qed.

Lemma norm2_zero p : norm2 p = 0 -> p = vzero.
Proof. destruct p as [x y z]. unfold norm2, dot, vzero; simpl. intros. f_equal; nra. Qed.

Lemma dist2_sym p q : dist2 p q = dist2 q p. Proof. vring. Qed.
Lemma dist2_nonneg p q : 0 <= dist2 p q. Proof. apply norm2_nonneg. Qed.

Lemma norm_nonneg p : 0 <= norm p. Proof. apply sqrt_pos. Qed.
Lemma norm_sqr p : norm p * norm p = norm2 p.
Proof. apply sqrt_sqrt, norm2_nonneg. Qed.
Lemma norm_pos p : p <> vzero -> 0 < norm p.
Proof.
  intros H. apply sqrt_lt_R0. destruct (Rle_lt_or_eq_dec 0 _ (norm2_nonneg p)) as [L|E]; auto.
  exfalso. apply H, norm2_zero. auto.
Qed.
Lemma dist_nonneg p q : 0 <= dist p q. Proof. apply norm_nonneg. Qed.
Lemma dist_sqr p q : dist p q * dist p q = dist2 p q. Proof. apply norm_sqr. Qed.
Lemma dist_sym p q : dist p q = dist q p.
Proof. unfold dist, norm. f_equal. apply dist2_sym. Qed.

(** Squares decide comparisons of nonnegative numbers. *)
Lemma sq_le a b : 0 <= b -> a * a <= b * b -> a <= b.
Proof. intros. nra. Qed.
Lemma sq_lt a b : 0 <= b -> a * a < b * b -> a < b.
Proof. intros. nra. Qed.
Lemma sq_le_mono a b : 0 <= a -> a <= b -> a * a <= b * b.
Proof. intros. nra. Qed.
Lemma sq_lt_mono a b : 0 <= a -> a < b -> a * a < b * b.
Proof. intros. nra. Qed.

(** Cauchy-Schwarz from Lagrange's identity. *)
Lemma lagrange p q : norm2 p * norm2 q - dot p q * dot p q = norm2 (cross p q).
Proof. vring. Qed.
Lemma cauchy_schwarz2 p q : dot p q * dot p q <= norm2 p * norm2 q.
Proof. pose proof (norm2_nonneg (cross p q)). rewrite <- lagrange in H. lra. Qed.
Lemma cauchy_schwarz p q : dot p q <= norm p * norm q.
Proof.
  apply sq_le. { apply Rmult_le_pos; apply norm_nonneg. }
  replace (norm p * norm q * (norm p * norm q)) with ((norm p * norm p) * (norm q * norm q)) by ring.
  rewrite !norm_sqr. apply cauchy_schwarz2.
Qed.

Lemma norm_triangle p q : norm (vadd p q) <= norm p + norm q.
Proof.
  apply sq_le. { pose proof (norm_nonneg p). pose proof (norm_nonneg q). lra. }
  rewrite norm_sqr. pose proof (cauchy_schwarz p q) as CS.
  pose proof (norm_sqr p) as P. pose proof (norm_sqr q) as Q.
  replace (norm2 (vadd p q)) with (norm2 p + norm2 q + 2 * dot p q) by vring.
  rewrite <- P, <- Q. lra.
Qed.
Lemma dist_triangle p q x : dist p x <= dist p q + dist q x.
Proof.
  unfold dist. replace (vsub p x) with (vadd (vsub p q) (vsub q x)) by (veq; ring).
  apply norm_triangle.
Qed.

Lemma norm_scale k p : norm (vscale k p) = Rabs k * norm p.
Proof.
  unfold norm. replace (norm2 (vscale k p)) with (k * k * norm2 p) by vring.
  rewrite sqrt_mult; [|nra|apply norm2_nonneg]. f_equal.
  rewrite <- (sqrt_Rsqr_abs k). reflexivity.
Qed.

(** sqrt 3, the constant of Chew's spacing. *)
Lemma sqrt3_sqr : sqrt 3 * sqrt 3 = 3. Proof. apply sqrt_sqrt; lra. Qed.
Lemma sqrt3_pos : 0 < sqrt 3. Proof. apply sqrt_lt_R0; lra. Qed.
Lemma sqrt3_bounds : 17/10 < sqrt 3 < 7/4.
Proof. pose proof sqrt3_sqr. pose proof sqrt3_pos. split; nra. Qed.
