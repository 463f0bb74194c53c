(* SPDX-License-Identifier: Apache-2.0 *)
(** * One accepted cell, one accepted subsegment *)
From Coq Require Import ZArith Arith List Bool Lia Reals Lra Psatz FMapPositive.
From Confidel.checker Require Import Space Statement Support Planar Crossing Walk Region Check Arithmetic Tables.
Import ListNotations.
Open Scope R_scope.

Lemma in_box_dec g b x : in_box g b x \/ ~ in_box g b x.
Proof.
  unfold in_box.
  destruct (Rle_dec (IZR (lox b)) (IZR g * cx x)); [|right; tauto]. destruct (Rle_dec (IZR g * cx x) (IZR (hix b))); [|right; tauto].
  destruct (Rle_dec (IZR (loy b)) (IZR g * cy x)); [|right; tauto]. destruct (Rle_dec (IZR g * cy x) (IZR (hiy b))); [|right; tauto].
  destruct (Rle_dec (IZR (loz b)) (IZR g * cz x)); [|right; tauto]. destruct (Rle_dec (IZR g * cz x) (IZR (hiz b))); [|right; tauto].
  left; tauto.
Qed.

Section Cells.
Variables (V : list point) (m : points) (sm : segments) (t : pairs) (tr : tree) (g : Z).
Hypothesis table_in : forall k p c, find k m = Some (p, c) -> (0 < hw p)%Z /\ In (real p) V.
Hypothesis table_all : forall v, In v V -> exists k p c, find k m = Some (p, c) /\ real p = v /\ in_tree k tr.
Hypothesis tree_fine : tree_ok m g tr = true.
Hypothesis g_pos : (0 < g)%Z.
Definition at_ (k : number) : point := match find k m with Some (p, _) => real p | None => origin end.
Lemma at_find k p c : find k m = Some (p, c) -> at_ k = real p.
Proof. unfold at_. intros ->. reflexivity. Qed.

Lemma query_all f q : query f q tr = true -> forall v, In v V -> in_box g q v -> exists k p c, find k m = Some (p, c) /\ real p = v /\ (0 < hw p)%Z /\ f k = true.
Proof.
  intros Q v Hv B. destruct (table_all v Hv) as (k & p & c & E & Ev & I). exists k, p, c.
  split; [exact E|]. split; [exact Ev|]. split; [apply (table_in _ _ _ E)|].
  eapply (query_spec m g (fun k p c H => proj1 (table_in k p c H))); eauto. rewrite Ev. exact B.
Qed.

(** ** Subsegments that hang *)
Lemma subsegment_sound T a b q : covering V T -> at_ a <> at_ b -> subsegment_ok m tr g a b q = true -> edge_of T (at_ a) (at_ b).
Proof.
  intros D N H. unfold subsegment_ok in H.
  destruct (find a m) as [[p ca]|] eqn:Ea; [|discriminate]. destruct (find b m) as [[p' cb]|] eqn:Eb; [|discriminate].
  destruct (common p p' p) as [[[w u] v] v'] eqn:E. destruct (table_in _ _ _ Ea) as [Pa Ia]. destruct (table_in _ _ _ Eb) as [Pb Ib].
  destruct (common_sound _ _ _ _ _ _ _ Pa Pb Pa E) as (W & E1 & E2 & _).
  rewrite (at_find _ _ _ Ea), (at_find _ _ _ Eb) in *.
  apply andb_true_iff in H. destruct H as [Bx Q]. set (s := diametral w u (vsub v u)) in *.
  assert (Sw : (0 < s_w s)%Z) by exact W. assert (Sd : (0 < s_d s)%Z) by reflexivity.
  assert (St : start s = real p) by (rewrite E1; reflexivity).
  assert (Th : dist2 (centre s) (real p') = dist2 (centre s) (start s)).
  { apply (through s (real p') (vsub v u)); auto.
    rewrite (over_minus w) by exact W. unfold start; cbn [s s_w s_a diametral]. rewrite E2. reflexivity. }
  apply (support_edge V T D (centre s) (real p) (real p') origin); auto.
  - rewrite Th, St. reflexivity.
  - intros x Hx. destruct (in_box_dec g q x) as [B|B].
    + destruct (query_all _ _ Q x Hx B) as (k & y & c & Ek & Ey & Py & F).
      destruct (number_eqb k a || number_eqb k b) eqn:Eab.
      * apply orb_true_iff in Eab. destruct Eab as [Eab|Eab]; apply number_eqb_spec in Eab; subst k.
        -- rewrite Ea in Ek. injection Ek; intros; subst y. rewrite <- Ey. lra.
        -- rewrite Eb in Ek. injection Ek; intros; subst y. rewrite <- Ey, Th, St. lra.
      * rewrite Ek in F. apply Z.ltb_lt, IZR_lt in F. destruct (power_sound s y Sw Sd Py) as (j & J & Ep). rewrite Ep in F.
        unfold zero in F. assert (0 < pow (centre s) (start s) (real y)) by (apply (Rmult_lt_reg_l j); lra). unfold pow in *. rewrite St, Ey in *. lra.
    + pose proof (ball_in_box_sound g s q x g_pos Sw Sd Bx B). rewrite St in *. lra.
  - unfold dot, origin; simpl; ring.
  - intros x Hx Ex. split; [unfold dot, origin; simpl; lra|]. intros _.
    destruct (in_box_dec g q x) as [B|B].
    + destruct (query_all _ _ Q x Hx B) as (k & y & c & Ek & Ey & Py & F).
      destruct (number_eqb k a || number_eqb k b) eqn:Eab.
      * apply orb_true_iff in Eab. destruct Eab as [Eab|Eab]; apply number_eqb_spec in Eab; subst k; [left|right]; congruence.
      * exfalso. rewrite Ek in F. apply Z.ltb_lt, IZR_lt in F. destruct (power_sound s y Sw Sd Py) as (j & J & Ep). rewrite Ep in F.
        unfold zero in F. assert (0 < pow (centre s) (start s) (real y)) by (apply (Rmult_lt_reg_l j); lra). unfold pow in *. rewrite St, Ey in *. lra.
    + exfalso. pose proof (ball_in_box_sound g s q x g_pos Sw Sd Bx B). rewrite St in *. lra.
Qed.

(** ** Cells *)
Section Plane.
Variables (x : context) (P N : point) (kn : R).
Let pl := x_plane x.
Hypotheses (Pw : (0 < p_w pl)%Z) (Po : over (p_w pl) (p_o pl) = P) (Kn : 0 < kn) (Pn : rvec (p_n pl) = scale kn N) (Pw2 : (0 < p_w2 pl)%Z).

Lemma on_plane_sound p : (0 < hw p)%Z -> on_plane pl p = true -> flat_at P N (real p).
Proof.
  intros W H. unfold on_plane in H. destruct (relative (p_w pl) (p_o pl) p) as [r k] eqn:E. destruct (relative_sound _ _ _ _ _ Pw W E) as [K Er].
  apply Z.eqb_eq, (f_equal IZR) in H. cbn [fst] in H. rewrite rvec_dot, Er, Pn, dot_scale, Po in H. unfold zero in H. pos Pw. pos K. unfold flat_at.
  apply (Rmult_eq_reg_l (kn * (IZR (p_w pl) * IZR k))); [lra|]. apply Rgt_not_eq. repeat apply Rmult_lt_0_compat; assumption.
Qed.
Lemma vdot_pos n n' : (0 < vdot n n')%Z -> (0 < vdot n n)%Z.
Proof.
  intro H. destruct (Z.eq_dec (vdot n n) 0) as [E|E].
  - exfalso. unfold vdot in *. assert (vx n = 0 /\ vy n = 0 /\ vz n = 0)%Z as (E1 & E2 & E3) by (repeat split; nia). rewrite E1, E2, E3 in H. lia.
  - unfold vdot in *. pose proof (Z.square_nonneg (vx n)). pose proof (Z.square_nonneg (vy n)). pose proof (Z.square_nonneg (vz n)). lia.
Qed.

Theorem cell_sound c : cell_ok m sm t tr g x c = true -> exists z, good P N V at_ (fun u w => lies_on m sm t x u w = true) (triple_of c) z.
Proof.
  intro H. unfold cell_ok in H. apply andb_true_iff in H. destruct H as [Sh H]. unfold cell_shape in Sh.
  apply andb_true_iff in Sh. destruct Sh as [Sh Off]. apply andb_true_iff in Sh. destruct Sh as [Sh Or]. apply andb_true_iff in Sh. destruct Sh as [Sh Cc].
  apply andb_true_iff in Sh. destruct Sh as [Ca Cb]. unfold corner_in in Ca, Cb, Cc.
  unfold locate in *.
  destruct (find (t_a c) m) as [[pa ka]|] eqn:Ea; [|discriminate]. destruct (find (t_b c) m) as [[pb kb]|] eqn:Eb; [|discriminate].
  destruct (find (t_c c) m) as [[pc kc]|] eqn:Ec; [|discriminate].
  apply andb_true_iff in Ca, Cb, Cc. destruct Ca as [_ Ca], Cb as [_ Cb], Cc as [_ Cc].
  destruct (table_in _ _ _ Ea) as [Wa Ia]. destruct (table_in _ _ _ Eb) as [Wb Ib]. destruct (table_in _ _ _ Ec) as [Wc Ic].
  apply (on_plane_sound _ Wa) in Ca. apply (on_plane_sound _ Wb) in Cb. apply (on_plane_sound _ Wc) in Cc.
  destruct (common pa pb pc) as [[[w a] b] d] eqn:E. destruct (common_sound _ _ _ _ _ _ _ Wa Wb Wc E) as (W & Ra & Rb & Rc). pos W.
  cbn [l_a l_b l_c l_w] in *. unfold cell_sphere in H; cbn [l_a l_b l_c l_w] in H.
  set (u := vsub b a) in *. set (v := vsub d a) in *. set (nn := vcross u v) in *.
  apply Z.ltb_lt in Or. fold pl in H, Or.
  set (s0 := smallest w a u v nn) in *.
  set (s := match t_offset c with None => s0 | Some (r, h) => moved s0 r h (p_n pl) (p_w2 pl) end) in *.
  assert (Un : rvec u = scale (IZR w) (minus (real pb) (real pa))) by (unfold u; rewrite (over_minus w), Ra, Rb by exact W; reflexivity).
  assert (Vn : rvec v = scale (IZR w) (minus (real pc) (real pa))) by (unfold v; rewrite (over_minus w), Ra, Rc by exact W; reflexivity).
  assert (D0 : (0 < s_d s0)%Z) by (unfold s0, smallest, two; cbn [s_d]; pose proof (vdot_pos _ _ Or); lia).
  assert (Sw : s_w s = w) by (unfold s; destruct (t_offset c) as [[r h]|]; reflexivity).
  assert (Sd : (0 < s_d s)%Z).
  { unfold s. destruct (t_offset c) as [[r h]|]; [|exact D0]. unfold moved; cbn [s_d]. apply Z.ltb_lt in Off. unfold zero in Off. apply Z.mul_pos_pos; [apply Z.mul_pos_pos; [exact D0|exact Off]|exact Pw2]. }
  assert (St : start s = real pa) by (rewrite Ra; unfold s; destruct (t_offset c) as [[r h]|]; reflexivity).
  assert (Sw' : (0 < s_w s)%Z) by (rewrite Sw; exact W).
  assert (T0 : forall y, y = u \/ y = v -> IZR (s_d s0) * dot (rvec y) (rvec y) = 2 * dot (rvec y) (rvec (s_m s0))).
  { intros y Hy. unfold s0, smallest, two; cbn [s_d s_m]. rewrite mult_IZR, rvec_dot, rvec_add, !rvec_scale, !rvec_cross, !rvec_dot.
    apply smallest_through; [apply rvec_cross|destruct Hy; subst y; auto]. }
  assert (Fu : forall y q, rvec y = scale (IZR w) (minus (real q) (real pa)) -> flat_at P N (real q) -> dot (rvec y) (rvec (p_n pl)) = 0).
  { intros y q Ey Fq. rewrite Ey, Pn, dot_scale. assert (Z : dot (minus (real q) (real pa)) N = 0) by (clear - Fq Ca; unfold flat_at, dot, minus in *; simpl in *; lra). rewrite Z. ring. }
  assert (Th : forall y q, y = u \/ y = v -> rvec y = scale (IZR w) (minus (real q) (real pa)) -> flat_at P N (real q) -> dist2 (centre s) (real q) = dist2 (centre s) (start s)).
  { intros y q Hy Ey Fq. apply (through s (real q) y); auto; [rewrite St, Sw; exact Ey|].
    specialize (T0 y Hy). specialize (Fu y q Ey Fq). unfold s. destruct (t_offset c) as [[r h]|]; [|exact T0].
    unfold moved; cbn [s_d s_m]. rewrite rvec_add, !rvec_scale, dot_plus_r, !dot_scale_r, Fu, !mult_IZR.
    transitivity (IZR h * IZR (p_w2 pl) * (IZR (s_d s0) * dot (rvec y) (rvec y))); [ring|]. rewrite T0. ring. }
  pose proof (Th u pb (or_introl eq_refl) Un Cb) as Tb. pose proof (Th v pc (or_intror eq_refl) Vn Cc) as Tc. clear T0 Fu Th. clearbody s.
  apply andb_true_iff in H. destruct H as [Bx Q].
  assert (Tu : 0 < turn N (real pa) (real pb) (real pc)).
  { apply IZR_lt in Or. unfold nn in Or. rewrite rvec_dot, rvec_cross, Un, Vn, cross_scale, Pn, dot_scale in Or. unfold zero in Or.
    unfold turn. replace (dot N (cross (minus (real pb) (real pa)) (minus (real pc) (real pa)))) with (dot (cross (minus (real pb) (real pa)) (minus (real pc) (real pa))) N) by (unfold dot; ring).
    apply (Rmult_lt_reg_l (IZR w * IZR w * kn)); [repeat apply Rmult_lt_0_compat; assumption|]. lra. }
  (* every point of V *)
  assert (J : forall y, In y V -> pow (centre s) (start s) y > 0 \/
     pow (centre s) (start s) y = 0 /\ flat_at P N y /\
     exists k p c', find k m = Some (p, c') /\ real p = y /\ (0 < hw p)%Z /\ (is_corner c k = true \/ tie_ok m sm t x c {| l_w := w; l_a := a; l_b := b; l_c := d |} p = true)).
  { intros y Hy. destruct (in_box_dec g (t_box c) y) as [B|B].
    - destruct (query_all _ _ Q y Hy B) as (k & p & c' & Ek & Ey & Py & F). unfold fine, judge in F. rewrite Ek in F.
      destruct (power_sound s p Sw' Sd Py) as (j & Jp & Ep). rewrite <- Ey.
      destruct (is_corner c k) eqn:Co.
      + right. assert (Z : pow (centre s) (start s) (real p) = 0 /\ flat_at P N (real p)).
        { unfold is_corner in Co. rewrite !orb_true_iff, !number_eqb_spec in Co.
          destruct Co as [[Co|Co]|Co]; subst k; [rewrite Ea in Ek|rewrite Eb in Ek|rewrite Ec in Ek]; injection Ek; intros; subst p; unfold pow; split; try assumption; rewrite ?St in *; lra. }
        split; [apply Z|]. split; [apply Z|]. exists k, p, c'. auto.
      + destruct (Z.ltb_spec zero (power s p)) as [L|L].
        * left. apply IZR_lt in L. rewrite Ep in L. unfold zero in L. apply (Rmult_lt_reg_l j); lra.
        * right. destruct (Z.eqb_spec (power s p) zero) as [Z|Z]; cbn [andb] in F; [|discriminate].
          destruct (on_plane (x_plane x) p) eqn:Op; [|discriminate].
          split; [|split; [apply on_plane_sound; assumption|]].
          -- apply (f_equal IZR) in Z. rewrite Ep in Z. unfold zero in Z. apply Rmult_integral in Z. lra.
          -- exists k, p, c'. split; [exact Ek|]. split; [reflexivity|]. split; [exact Py|].
             destruct (tie_ok _ _ _ _ _ _ p); [auto|discriminate].
    - left. pose proof (ball_in_box_sound g s _ y g_pos Sw' Sd Bx B). unfold pow. lra. }
  exists (centre s). unfold triple_of.
  assert (Aa : at_ (t_a c) = real pa) by (eapply at_find; eauto). assert (Ab : at_ (t_b c) = real pb) by (eapply at_find; eauto). assert (Ac : at_ (t_c c) = real pc) by (eapply at_find; eauto).
  split; rewrite ?Aa, ?Ab, ?Ac.
  - auto.
  - auto.
  - exact Tu.
  - rewrite <- St. auto.
  - intros y Hy. rewrite <- St. destruct (J y Hy) as [K|(K & F & _)]; unfold pow in K; split; try lra. intros _. exact F.
  - intros y e f Hy He Li Ey.
    assert (Eu : dist2 (centre s) (at_ e) = dist2 (centre s) (start s)).
    { unfold sides in He. cbn [In] in He. destruct He as [He|[He|[He|[]]]]; injection He; intros; subst e f; rewrite ?Aa, ?Ab, ?Ac; [rewrite St|..]; auto. }
    destruct (J y Hy) as [K|(_ & _ & k & p & c' & Ek & Ep & Py & [Co|Ti])]; [unfold pow in K; exfalso; lra| |].
    + unfold is_corner in Co. rewrite !orb_true_iff, !number_eqb_spec in Co.
      assert (Y : y = real pa \/ y = real pb \/ y = real pc).
      { rewrite <- Ep, <- (at_find _ _ _ Ek). destruct Co as [[->| ->]| ->]; auto. }
      unfold sides in He. cbn [In] in He. destruct He as [He|[He|[He|[]]]]; injection He; intros; subst e f; rewrite ?Aa, ?Ab, ?Ac;
        destruct Y as [->|[->| ->]]; rewrite ?turn_same, ?turn_same'; try lra; first [lra | rewrite turn_rot; lra | rewrite turn_rot, turn_rot; lra].
    + unfold tie_ok in Ti. cbn [l_w l_a l_b l_c] in Ti.
      apply andb_true_iff in Ti. destruct Ti as [Ti T3]. apply andb_true_iff in Ti. destruct Ti as [T1 T2].
      assert (Sg : forall i j, side (p_n (x_plane x)) w i j p = true -> 0 <= turn N (over w i) (over w j) y).
      { intros i j Hs. unfold side in Hs. apply Z.leb_le, IZR_le in Hs. unfold zero in Hs.
        destruct (turn_sound w i j p N (p_n pl) kn W Py Kn Pn) as (cc & Pc & Ecc). fold pl in Hs. rewrite Ecc in Hs. rewrite Ep in Hs.
        apply (Rmult_le_reg_l cc); lra. }
      unfold sides in He. cbn [In] in He. destruct He as [He|[He|[He|[]]]]; injection He; intros; subst e f; rewrite ?Aa, ?Ab, ?Ac, ?Ra, ?Rb, ?Rc.
      * rewrite Li in T1. apply Sg. exact T1. * rewrite Li in T2. apply Sg. exact T2. * rewrite Li in T3. apply Sg. exact T3.
Qed.
End Plane.
End Cells.

(** ** An edge of a cell that lies on a segment is an edge of every subdivision *)
Lemma fixed_edge o n V at_ fixed T c z u w : n <> origin -> covering V T -> good o n V at_ fixed c z -> In (u, w) (sides c) -> fixed u w ->
  edge_of T (at_ u) (at_ w).
Proof.
  intros N0 D G Hu Hf. destruct (see o n V at_ fixed c z u w G Hu) as [d [F I Tn [H H'] E _]].
  assert (Ne : at_ u <> at_ w) by (intro K; rewrite K, turn_refl in Tn; lra).
  assert (Tg : forall v, dot (cross n (minus (at_ w) (at_ u))) (minus v (at_ u)) = turn n (at_ u) (at_ w) v) by (intro; unfold turn, dot, cross, minus; simpl; ring).
  apply (support_edge V T D z (at_ u) (at_ w) (cross n (minus (at_ w) (at_ u)))); try tauto.
  - intros v Hv. apply (E v Hv).
  - rewrite Tg. apply turn_same'.
  - intros v Hv Ev. rewrite Tg. split; [apply (good_tie _ _ _ _ _ _ _ G v u w); auto|]. intro Z.
    assert (Fv : flat_at o n v) by (apply (E v Hv); exact Ev).
    destruct (bary o n N0 (at_ u) (at_ w) (at_ d) v) as (B1 & B2 & B3); try tauto.
    pose proof (turn_sum n (at_ u) (at_ w) (at_ d) v) as S. rewrite Z in B1, B2, B3, S.
    set (k := turn n (at_ u) (at_ w) (at_ d)) in *. set (l := turn n (at_ d) (at_ u) v) in *.
    assert (Ek : v = towards (at_ u) (at_ w) (l / k)).
    { replace (turn n (at_ w) (at_ d) v) with (k - l) in * by lra. clearbody k l. clear - B1 B2 B3 Tn. destruct v as [v1 v2 v3]. unfold towards; simpl in *.
      f_equal; apply (Rmult_eq_reg_l k); try lra; [rewrite B1|rewrite B2|rewrite B3]; field; lra. }
    assert (Pv : pow z (at_ u) v = 0) by (unfold pow; lra). rewrite Ek, pow_towards in Pv. unfold pow in Pv. rewrite H in Pv.
    assert (Q : 0 < dist2 (at_ u) (at_ w)).
    { destruct (Req_dec (dist2 (at_ u) (at_ w)) 0) as [Y|Y]; [exfalso; apply Ne, dist2_zero; exact Y|]. pose proof (dist2_nonneg (at_ u) (at_ w)). lra. }
    set (s := l / k) in *. clearbody s.
    assert (M : s * (1 - s) * dist2 (at_ u) (at_ w) = 0) by lra. apply Rmult_integral in M. destruct M as [M|M]; [|lra]. apply Rmult_integral in M.
    rewrite Ek. unfold towards. destruct M as [M|M]; [left|right].
    + rewrite M. destruct (at_ u); simpl; f_equal; ring.
    + replace s with 1 by lra. destruct (at_ w); simpl; f_equal; ring.
Qed.
