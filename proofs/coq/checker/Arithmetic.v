(* SPDX-License-Identifier: Apache-2.0 *)
(** * What the integer predicates say about real points *)
From Coq Require Import ZArith List Bool Lia Reals Lra Psatz.
From Confidel.checker Require Import Space Statement Planar Check.
Import ListNotations.
Open Scope R_scope.

Definition scale k a := Point (k * cx a) (k * cy a) (k * cz a).
Definition plus a b := Point (cx a + cx b) (cy a + cy b) (cz a + cz b).
Definition rvec (a : vec) := Point (IZR (vx a)) (IZR (vy a)) (IZR (vz a)).
(** the point a/w *)
Definition over (w : Z) (a : vec) := scale (/ IZR w) (rvec a).

Ltac push := repeat (rewrite plus_IZR || rewrite minus_IZR || rewrite mult_IZR).
Lemma rvec_sub a b : rvec (vsub a b) = minus (rvec a) (rvec b).
Proof. unfold rvec, vsub, minus; simpl. f_equal; push; ring. Qed.
Lemma rvec_add a b : rvec (vadd a b) = plus (rvec a) (rvec b).
Proof. unfold rvec, vadd, plus; simpl. f_equal; push; ring. Qed.
Lemma rvec_scale k a : rvec (vscale k a) = scale (IZR k) (rvec a).
Proof. unfold rvec, vscale, scale; simpl. f_equal; push; ring. Qed.
Lemma rvec_cross a b : rvec (vcross a b) = cross (rvec a) (rvec b).
Proof. unfold rvec, vcross, cross; simpl. f_equal; push; ring. Qed.
Lemma rvec_dot a b : IZR (vdot a b) = dot (rvec a) (rvec b).
Proof. unfold rvec, vdot, dot; simpl. push; ring. Qed.
Lemma dot_scale k l a b : dot (scale k a) (scale l b) = k * l * dot a b.
Proof. unfold dot, scale; simpl. ring. Qed.
Lemma dot_scale_l k a b : dot (scale k a) b = k * dot a b.
Proof. unfold dot, scale; simpl. ring. Qed.
Lemma dot_scale_r k a b : dot a (scale k b) = k * dot a b.
Proof. unfold dot, scale; simpl. ring. Qed.
Lemma cross_scale k l a b : cross (scale k a) (scale l b) = scale (k * l) (cross a b).
Proof. unfold cross, scale; simpl. f_equal; ring. Qed.
Lemma dot_plus_r a b c : dot a (plus b c) = dot a b + dot a c.
Proof. unfold dot, plus; simpl. ring. Qed.
Lemma minus_scale k a b : minus (scale k a) (scale k b) = scale k (minus a b).
Proof. unfold minus, scale; simpl. f_equal; ring. Qed.
Lemma IZR_pos z : (0 < z)%Z -> 0 < IZR z.
Proof. apply IZR_lt. Qed.
Ltac pos H := pose proof (IZR_pos _ H).

Ltac bools := repeat match goal with
  | H : _ && _ = true |- _ => apply andb_true_iff in H; destruct H
  | H : (_ <=? _)%Z = true |- _ => apply Z.leb_le in H
  | H : (_ <? _)%Z = true |- _ => apply Z.ltb_lt in H
  | H : (_ =? _)%Z = true |- _ => apply Z.eqb_eq in H end.

Lemma same_point_sound p q : same_point p q = true -> real q = real p /\ (0 < hw p)%Z /\ (0 < hw q)%Z.
Proof.
  unfold same_point, zero. intro H. bools. split; [|auto]. pos H. pos H3.
  apply (f_equal IZR) in H0, H1, H2. rewrite !mult_IZR in *. unfold real. f_equal.
  - apply (Rmult_eq_reg_r (IZR (hw p) * IZR (hw q))); [|apply Rgt_not_eq, Rmult_lt_0_compat; assumption]. field_simplify; lra.
  - apply (Rmult_eq_reg_r (IZR (hw p) * IZR (hw q))); [|apply Rgt_not_eq, Rmult_lt_0_compat; assumption]. field_simplify; lra.
  - apply (Rmult_eq_reg_r (IZR (hw p) * IZR (hw q))); [|apply Rgt_not_eq, Rmult_lt_0_compat; assumption]. field_simplify; lra.
Qed.
Lemma real_num p : real p = over (hw p) (num p).
Proof. unfold real, over, num, scale, rvec; simpl. f_equal; unfold Rdiv; ring. Qed.

Lemma relative_sound w a p r k : (0 < w)%Z -> (0 < hw p)%Z -> relative w a p = (r, k) ->
  (0 < k)%Z /\ rvec r = scale (IZR w * IZR k) (minus (real p) (over w a)).
Proof.
  intros W P E. unfold relative, one in E. pos W. pos P. rewrite real_num.
  destruct (Z.eqb_spec (hw p) w) as [Q|Q]; injection E; intros; subst r k; clear E.
  - split; [lia|]. rewrite Q, rvec_sub. unfold over. rewrite minus_scale.
    unfold scale; destruct (minus (rvec (num p)) (rvec a)); simpl. f_equal; field; lra.
  - split; [exact P|]. rewrite rvec_sub, !rvec_scale. unfold over, minus, scale; simpl. f_equal; field; lra.
Qed.
Lemma over_mult k w a : (0 < k)%Z -> (0 < w)%Z -> over (k * w) (vscale k a) = over w a.
Proof. intros K W. pos K. pos W. unfold over. rewrite rvec_scale, mult_IZR. unfold scale; simpl. f_equal; field; lra. Qed.
Lemma common_sound p q r w a b c : (0 < hw p)%Z -> (0 < hw q)%Z -> (0 < hw r)%Z -> common p q r = (w, a, b, c) ->
  (0 < w)%Z /\ real p = over w a /\ real q = over w b /\ real r = over w c.
Proof.
  intros P Q R E. unfold common in E. rewrite !real_num.
  destruct (Z.eqb_spec (hw p) (hw q)) as [E1|E1]; [destruct (Z.eqb_spec (hw p) (hw r)) as [E2|E2]|]; cbn [andb] in E;
    injection E; intros; subst; clear E.
  - rewrite <- E1, <- E2. auto.
  - split; [lia|]. repeat split.
    + rewrite <- (over_mult (hw q * hw r) (hw p)); [f_equal; ring|lia|lia].
    + rewrite <- (over_mult (hw p * hw r) (hw q)); [f_equal; ring|lia|lia].
    + rewrite <- (over_mult (hw p * hw q) (hw r)); [f_equal; ring|lia|lia].
  - split; [lia|]. repeat split.
    + rewrite <- (over_mult (hw q * hw r) (hw p)); [f_equal; ring|lia|lia].
    + rewrite <- (over_mult (hw p * hw r) (hw q)); [f_equal; ring|lia|lia].
    + rewrite <- (over_mult (hw p * hw q) (hw r)); [f_equal; ring|lia|lia].
Qed.
Lemma over_minus w a b : (0 < w)%Z -> rvec (vsub b a) = scale (IZR w) (minus (over w b) (over w a)).
Proof. intros W. pos W. rewrite rvec_sub. unfold over, minus, scale; simpl. f_equal; field; lra. Qed.

(** ** Spheres *)
Definition start s := over (s_w s) (s_a s).
Definition centre s := plus (start s) (scale (/ (IZR (s_d s) * IZR (s_w s))) (rvec (s_m s))).
Lemma pow_dot z a x : pow z a x = dot (minus x a) (minus x a) - 2 * dot (minus x a) (minus z a).
Proof. unfold pow, dist2, dot, minus; simpl. ring. Qed.
Lemma centre_minus s : minus (centre s) (start s) = scale (/ (IZR (s_d s) * IZR (s_w s))) (rvec (s_m s)).
Proof. unfold centre, plus, minus; simpl. unfold scale; f_equal; simpl; ring. Qed.
Lemma power_sound s p : (0 < s_w s)%Z -> (0 < s_d s)%Z -> (0 < hw p)%Z ->
  exists k, 0 < k /\ IZR (power s p) = k * pow (centre s) (start s) (real p).
Proof.
  intros W D P. unfold power. destruct (relative (s_w s) (s_a s) p) as [r k] eqn:E.
  destruct (relative_sound _ _ _ _ _ W P E) as [K Er]. pos W. pos D. pos K.
  exists (IZR (s_d s) * (IZR (s_w s) * IZR k) * (IZR (s_w s) * IZR k)). split; [repeat apply Rmult_lt_0_compat; assumption|].
  unfold two. rewrite minus_IZR, !mult_IZR, !rvec_dot, Er, dot_scale, dot_scale_l, pow_dot, centre_minus, dot_scale_r.
  fold (start s). field. lra.
Qed.
Lemma radius s : dist2 (centre s) (start s) = / (IZR (s_d s) * IZR (s_w s)) * / (IZR (s_d s) * IZR (s_w s)) * dot (rvec (s_m s)) (rvec (s_m s)).
Proof. unfold dist2. rewrite centre_minus, dot_scale. reflexivity. Qed.
Lemma through s b u : (0 < s_w s)%Z -> (0 < s_d s)%Z -> rvec u = scale (IZR (s_w s)) (minus b (start s)) ->
  IZR (s_d s) * dot (rvec u) (rvec u) = 2 * dot (rvec u) (rvec (s_m s)) -> dist2 (centre s) b = dist2 (centre s) (start s).
Proof.
  intros W D U E. pos W. pos D. cut (pow (centre s) (start s) b = 0); [unfold pow; lra|].
  rewrite pow_dot, centre_minus, dot_scale_r. rewrite U, dot_scale, dot_scale_l in E.
  apply (Rmult_eq_reg_l (IZR (s_d s) * IZR (s_w s) * IZR (s_w s))); [|apply Rgt_not_eq; repeat apply Rmult_lt_0_compat; assumption].
  rewrite Rmult_0_r. transitivity (IZR (s_d s) * (IZR (s_w s) * IZR (s_w s) * dot (minus b (start s)) (minus b (start s))) - 2 * (IZR (s_w s) * dot (minus b (start s)) (rvec (s_m s)))).
  - field. lra.
  - rewrite E. ring.
Qed.
Lemma smallest_through u v n x : n = cross u v -> x = u \/ x = v ->
  2 * dot n n * dot x x = 2 * dot x (plus (scale (dot u u) (cross v n)) (scale (dot v v) (cross n u))).
Proof. intros -> [->| ->]; unfold dot, plus, scale, cross; simpl; ring. Qed.

(** ** Boxes *)
Definition in_box (g : Z) (b : box) (x : point) :=
  (IZR (lox b) <= IZR g * cx x <= IZR (hix b)) /\ (IZR (loy b) <= IZR g * cy x <= IZR (hiy b)) /\ (IZR (loz b) <= IZR g * cz x <= IZR (hiz b)).
Lemma point_in_box_sound g b p : (0 < hw p)%Z -> point_in_box g b p = true -> in_box g b (real p).
Proof.
  intros P H. unfold point_in_box in H. bools. pos P. apply IZR_le in H, H0, H1, H2, H3, H4. rewrite !mult_IZR in *.
  unfold in_box, real; simpl.
  assert (K : forall x, IZR (hw p) * (IZR g * (x / IZR (hw p))) = IZR g * x) by (intro; field; lra).
  repeat split; apply (Rmult_le_reg_l (IZR (hw p))); try assumption; rewrite K; assumption.
Qed.
Lemma box_in_box_sound g b c x : box_in_box b c = true -> in_box g c x -> in_box g b x.
Proof. unfold box_in_box, in_box. intros H I. bools. apply IZR_le in H, H0, H1, H2, H3, H4. repeat split; lra. Qed.
Lemma apart_sound g b c x : apart b c = true -> in_box g c x -> ~ in_box g b x.
Proof.
  unfold apart, in_box. intros H I J. repeat rewrite orb_true_iff in H. repeat rewrite Z.ltb_lt in H.
  repeat (destruct H as [H|H]; [|]); apply IZR_lt in H; lra.
Qed.
Lemma beyond : forall g z r2 h x, 0 < g -> 0 <= h - g * z -> g * g * r2 <= (h - g * z) * (h - g * z) -> h < g * x -> r2 < (z - x) * (z - x).
Proof.
  intros g z r2 h x G A B C. apply (Rmult_lt_reg_l (g * g)); [apply Rmult_lt_0_compat; assumption|].
  apply Rle_lt_trans with (1 := B). replace (g * g * ((z-x)*(z-x))) with ((g*x - g*z)*(g*x - g*z)) by ring.
  apply Rmult_le_0_lt_compat; lra.
Qed.
Lemma ball_in_box_sound g s b x : (0 < g)%Z -> (0 < s_w s)%Z -> (0 < s_d s)%Z -> ball_in_box g s b = true -> ~ in_box g b x ->
  dist2 (centre s) (start s) < dist2 (centre s) x.
Proof.
  intros G W D H N. pos G. pos W. pos D. unfold ball_in_box in H.
  set (f := if (s_w s =? g)%Z then one else g) in *.
  set (c := if (s_w s =? g)%Z then IZR (s_d s) else IZR (s_d s) * IZR (s_w s)).
  assert (C : 0 < c) by (unfold c; destruct (s_w s =? g)%Z; [assumption|apply Rmult_lt_0_compat; assumption]).
  set (R2 := dist2 (centre s) (start s)).
  assert (R : IZR (f * f * vdot (s_m s) (s_m s)) = c * c * (IZR g * IZR g * R2)).
  { unfold R2. rewrite radius, !mult_IZR, rvec_dot. unfold f, c, one. destruct (Z.eqb_spec (s_w s) g) as [E|E]; [rewrite E|]; field; lra. }
  assert (gap : forall h a m, IZR (s_d s * (if (s_w s =? g)%Z then h - a else h * s_w s - g * a) - f * m) =
     c * (IZR h - IZR g * (/ IZR (s_w s) * IZR a + / (IZR (s_d s) * IZR (s_w s)) * IZR m))).
  { intros. unfold f, c, one. destruct (Z.eqb_spec (s_w s) g) as [E|E]; [rewrite E|]; push; field; lra. }
  assert (gap' : forall h a m, IZR (f * m - s_d s * (if (s_w s =? g)%Z then h - a else h * s_w s - g * a)) =
     c * (IZR g * (/ IZR (s_w s) * IZR a + / (IZR (s_d s) * IZR (s_w s)) * IZR m) - IZR h)).
  { intros. replace (f * m - s_d s * (if (s_w s =? g)%Z then h - a else h * s_w s - g * a))%Z with (- (s_d s * (if (s_w s =? g)%Z then h - a else h * s_w s - g * a) - f * m))%Z by ring.
    rewrite opp_IZR, gap. ring. }
  assert (far : forall e t, IZR e = c * t -> (zero <= e)%Z -> (f * f * vdot (s_m s) (s_m s) <= e * e)%Z -> 0 <= t /\ IZR g * IZR g * R2 <= t * t).
  { clear H. intros e t E H3 H4. unfold zero in H3. apply IZR_le in H3, H4. rewrite R, mult_IZR, E in H4. rewrite E in H3. split.
    - apply (Rmult_le_reg_l c); lra.
    - apply (Rmult_le_reg_l (c * c)); [apply Rmult_lt_0_compat; assumption|]. lra. }
  bools.
  assert (Zx : cx (centre s) = / IZR (s_w s) * IZR (vx (s_a s)) + / (IZR (s_d s) * IZR (s_w s)) * IZR (vx (s_m s))) by reflexivity.
  assert (Zy : cy (centre s) = / IZR (s_w s) * IZR (vy (s_a s)) + / (IZR (s_d s) * IZR (s_w s)) * IZR (vy (s_m s))) by reflexivity.
  assert (Zz : cz (centre s) = / IZR (s_w s) * IZR (vz (s_a s)) + / (IZR (s_d s) * IZR (s_w s)) * IZR (vz (s_m s))) by reflexivity.
  assert (sq : forall t, 0 <= t * t) by (intro t; apply Rle_0_sqr).
  assert (fin : R2 < (cx (centre s) - cx x) * (cx (centre s) - cx x) \/ R2 < (cy (centre s) - cy x) * (cy (centre s) - cy x) \/ R2 < (cz (centre s) - cz x) * (cz (centre s) - cz x)).
  { unfold in_box in N.
    assert (up : forall h z y, IZR h < IZR g * y -> 0 <= IZR h - IZR g * z /\ IZR g * IZR g * R2 <= (IZR h - IZR g * z) * (IZR h - IZR g * z) -> R2 < (z - y) * (z - y)).
    { intros h z y L [A B]. apply (beyond (IZR g) z R2 (IZR h) y); assumption. }
    assert (down : forall h z y, IZR g * y < IZR h -> 0 <= IZR g * z - IZR h /\ IZR g * IZR g * R2 <= (IZR g * z - IZR h) * (IZR g * z - IZR h) -> R2 < (z - y) * (z - y)).
    { intros h z y L [A B]. replace ((z-y)*(z-y)) with ((-z - -y)*(-z - -y)) by ring. apply (beyond (IZR g) (-z) R2 (- IZR h) (-y)); try lra. }
    destruct (Rle_dec (IZR (lox b)) (IZR g * cx x)) as [L1|L1]; [|left; eapply down; [apply Rnot_le_lt; exact L1|rewrite Zx; eapply far; [apply gap'|eassumption|eassumption]]].
    { destruct (Rle_dec (IZR g * cx x) (IZR (hix b))) as [L2|L2]; [|left; eapply up; [apply Rnot_le_lt; exact L2|rewrite Zx; eapply far; [apply gap|eassumption|eassumption]]].
      destruct (Rle_dec (IZR (loy b)) (IZR g * cy x)) as [L3|L3]; [|right; left; eapply down; [apply Rnot_le_lt; exact L3|rewrite Zy; eapply far; [apply gap'|eassumption|eassumption]]].
      destruct (Rle_dec (IZR g * cy x) (IZR (hiy b))) as [L4|L4]; [|right; left; eapply up; [apply Rnot_le_lt; exact L4|rewrite Zy; eapply far; [apply gap|eassumption|eassumption]]].
      destruct (Rle_dec (IZR (loz b)) (IZR g * cz x)) as [L5|L5]; [|right; right; eapply down; [apply Rnot_le_lt; exact L5|rewrite Zz; eapply far; [apply gap'|eassumption|eassumption]]].
      destruct (Rle_dec (IZR g * cz x) (IZR (hiz b))) as [L6|L6]; [|right; right; eapply up; [apply Rnot_le_lt; exact L6|rewrite Zz; eapply far; [apply gap|eassumption|eassumption]]].
      exfalso. apply N. auto. } }
  change (dist2 (centre s) x) with ((cx (centre s) - cx x) * (cx (centre s) - cx x) + (cy (centre s) - cy x) * (cy (centre s) - cy x) + (cz (centre s) - cz x) * (cz (centre s) - cz x)).
  pose proof (sq (cx (centre s) - cx x)). pose proof (sq (cy (centre s) - cy x)). pose proof (sq (cz (centre s) - cz x)). lra.
Qed.

(** ** Order on a line, planes, orientation *)
Lemma between_sound p m q : (0 < hw p)%Z -> (0 < hw m)%Z -> (0 < hw q)%Z -> between p m q = true ->
  exists s, 0 < s < 1 /\ real m = towards (real p) (real q) s.
Proof.
  intros P M Q H. unfold between in H. destruct (common p m q) as [[[w a] b] c] eqn:E.
  destruct (common_sound _ _ _ _ _ _ _ P M Q E) as (W & -> & -> & ->). pos W. unfold zero in H.
  apply andb_true_iff in H. destruct H as [H Hd]. apply andb_true_iff in H. destruct H as [H Hz]. apply andb_true_iff in H. destruct H as [Hx Hy].
  apply Z.eqb_eq in Hx, Hy, Hz. apply Z.ltb_lt in Hd.
  set (u := minus (over w b) (over w a)). set (v := minus (over w c) (over w b)).
  assert (X : cross u v = origin).
  { pose proof (rvec_cross (vsub b a) (vsub c b)) as K. rewrite !(over_minus w), cross_scale in K by exact W. fold u v in K.
    assert (Z : rvec (vcross (vsub b a) (vsub c b)) = origin) by (unfold rvec, origin; rewrite Hx, Hy, Hz; reflexivity).
    rewrite Z in K. unfold scale, origin in *. destruct (cross u v) as [x y z]. simpl in K. injection K; intros K3 K2 K1.
    assert (N : IZR w * IZR w <> 0) by (apply Rgt_not_eq, Rmult_lt_0_compat; assumption).
    f_equal; apply (Rmult_eq_reg_l (IZR w * IZR w)); auto; lra. }
  assert (Dv : 0 < dot u v).
  { apply IZR_lt in Hd. rewrite rvec_dot, !(over_minus w), dot_scale in Hd by exact W. fold u v in Hd.
    apply (Rmult_lt_reg_l (IZR w * IZR w)); [apply Rmult_lt_0_compat; assumption|]. lra. }
  assert (Em : over w b = plus (over w a) u) by (unfold u, plus, minus; destruct (over w a), (over w b); simpl; f_equal; ring).
  assert (Eq : over w c = plus (over w b) v) by (unfold v, plus, minus; destruct (over w c), (over w b); simpl; f_equal; ring).
  rewrite Eq, Em. clearbody u v. generalize (over w a). clear - X Dv. intro a.
  destruct u as [u1 u2 u3], v as [v1 v2 v3], a as [a1 a2 a3]. unfold cross, origin, dot, towards, plus in *; simpl in *. injection X; intros X3 X2 X1.
  set (k := u1*v1+u2*v2+u3*v3) in *. set (l := u1*u1+u2*u2+u3*u3).
  assert (L : 0 <= l) by (unfold l; pose proof (Rle_0_sqr u1); pose proof (Rle_0_sqr u2); pose proof (Rle_0_sqr u3); unfold Rsqr in *; lra).
  assert (L' : 0 < l).
  { destruct (Req_dec l 0) as [Z|]; [exfalso|lra]. pose proof (Rle_0_sqr u1) as S1. pose proof (Rle_0_sqr u2) as S2. pose proof (Rle_0_sqr u3) as S3. unfold Rsqr, l in *.
    assert (I1 : u1*u1 = 0) by lra. assert (I2 : u2*u2 = 0) by lra. assert (I3 : u3*u3 = 0) by lra. apply Rmult_integral in I1, I2, I3.
    assert (Y1 : u1 = 0) by lra. assert (Y2 : u2 = 0) by lra. assert (Y3 : u3 = 0) by lra. unfold k in Dv. rewrite Y1, Y2, Y3 in Dv. lra. }
  assert (S : 0 < l + k) by lra. assert (I := Rinv_0_lt_compat _ S).
  (* v = (k/l) u *)
  assert (V1 : l * v1 = k * u1) by (unfold l, k; replace ((u1*u1+u2*u2+u3*u3)*v1) with ((u1*v1+u2*v2+u3*v3)*u1 - (u1*v2-u2*v1)*u2 + (u3*v1-u1*v3)*u3) by ring; rewrite X3, X2; ring).
  assert (V2 : l * v2 = k * u2) by (unfold l, k; replace ((u1*u1+u2*u2+u3*u3)*v2) with ((u1*v1+u2*v2+u3*v3)*u2 + (u1*v2-u2*v1)*u1 - (u2*v3-u3*v2)*u3) by ring; rewrite X3, X1; ring).
  assert (V3 : l * v3 = k * u3) by (unfold l, k; replace ((u1*u1+u2*u2+u3*u3)*v3) with ((u1*v1+u2*v2+u3*v3)*u3 + (u2*v3-u3*v2)*u2 - (u3*v1-u1*v3)*u1) by ring; rewrite X1, X2; ring).
  exists (l / (l + k)). split; [split|].
  - apply Rmult_lt_0_compat; assumption.
  - apply (Rmult_lt_reg_r (l + k)); [exact S|]. replace (l/(l+k)*(l+k)) with l by (field; lra). lra.
  - assert (G : forall x y z, l * z = k * y -> x + y = x + l / (l + k) * (x + y + z - x)).
    { intros x y z K. apply Rplus_eq_compat_l. apply (Rmult_eq_reg_l (l + k)); [|lra]. replace ((l+k) * (l/(l+k) * (x+y+z-x))) with (l*y + l*z) by (field; lra). rewrite K. ring. }
    f_equal; apply G; assumption.
Qed.
Lemma turn_sound w u v p (N : point) n k : (0 < w)%Z -> (0 < hw p)%Z -> 0 < k -> rvec n = scale k N ->
  exists c, 0 < c /\ IZR (vdot n (vcross (vsub v u) (fst (relative w u p)))) = c * turn N (over w u) (over w v) (real p).
Proof.
  intros W P K En. destruct (relative w u p) as [r j] eqn:E. destruct (relative_sound _ _ _ _ _ W P E) as [J Er]. pos W. pos J. cbn [fst].
  exists (k * (IZR w * (IZR w * IZR j))). split; [repeat apply Rmult_lt_0_compat; assumption|].
  rewrite rvec_dot, rvec_cross, (over_minus w) by exact W. rewrite Er, En, cross_scale, dot_scale. unfold turn. reflexivity.
Qed.
