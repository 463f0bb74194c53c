(* SPDX-License-Identifier: Apache-2.0 *)
(** * Crossing numbers of a triangle and of a subdivided edge *)
From Coq Require Import ZArith List Bool Lia Reals Lra Psatz.
From Confidel.checker Require Import Space Statement.
Open Scope R_scope.

Lemma area2_swap : forall p q x, area2 q p x = - area2 p q x.
Proof. intros. unfold area2. ring. Qed.
Lemma area2_sum : forall a b c x, area2 a b x + area2 b c x + area2 c a x = area2 a b c.
Proof. intros. unfold area2. ring. Qed.
Lemma area2_height : forall a b c x,
  area2 a b x * (snd c - snd x) + area2 b c x * (snd a - snd x) + area2 c a x * (snd b - snd x) = 0.
Proof. intros. unfold area2. ring. Qed.

Ltac cases := unfold below; repeat match goal with
  | |- context [Rlt_dec ?a ?b] => destruct (Rlt_dec a b); try (exfalso; lra) end; cbn.

Lemma crossing_swap : forall x p q, crossing x q p = (- crossing x p q)%Z.
Proof. intros x p q. unfold crossing. rewrite (area2_swap p q). cases; reflexivity. Qed.

(** the sign of a product, as a hypothesis *)
Ltac mul u v := first [
   assert (0 < u*v) by (apply Rmult_lt_0_compat; lra) | assert (0 < (-u)*v) by (apply Rmult_lt_0_compat; lra)
 | assert (0 < u*(-v)) by (apply Rmult_lt_0_compat; lra) | assert (0 < (-u)*(-v)) by (apply Rmult_lt_0_compat; lra)
 | assert (0 <= u*v) by (apply Rmult_le_pos; lra) | assert (0 <= (-u)*v) by (apply Rmult_le_pos; lra)
 | assert (0 <= u*(-v)) by (apply Rmult_le_pos; lra) | assert (0 <= (-u)*(-v)) by (apply Rmult_le_pos; lra) | idtac ].

(** The crossings of a counter-clockwise triangle's edges add up to 0 or 1: 1 at every inner point, 0 at every outer point.
    (On its boundary it may be either: that depends on the direction of the ray, and needs no care.) *)
Definition crossing3 x a b c : Z := (crossing x a b + crossing x b c + crossing x c a)%Z.
Lemma crossing_triangle : forall x a b c, 0 < area2 a b c ->
  (0 <= crossing3 x a b c)%Z /\
  (crossing3 x a b c <> 0%Z -> 0 <= area2 a b x /\ 0 <= area2 b c x /\ 0 <= area2 c a x) /\
  (0 < area2 a b x -> 0 < area2 b c x -> 0 < area2 c a x -> crossing3 x a b c = 1%Z).
Proof.
  intros x a b c O. pose proof (area2_sum a b c x) as S. pose proof (area2_height a b c x) as H.
  assert (HA : snd a = snd x -> snd b = snd x -> area2 a b x = 0) by (unfold area2; intros -> ->; ring).
  assert (HB : snd b = snd x -> snd c = snd x -> area2 b c x = 0) by (unfold area2; intros -> ->; ring).
  assert (HC : snd c = snd x -> snd a = snd x -> area2 c a x = 0) by (unfold area2; intros -> ->; ring).
  unfold crossing3, crossing.
  set (A := area2 a b x) in *. set (B := area2 b c x) in *. set (C := area2 c a x) in *.
  set (D := area2 a b c) in *. clearbody A B C D.
  set (ya := snd a) in *. set (yb := snd b) in *. set (yc := snd c) in *. set (y := snd x) in *.
  clearbody ya yb yc y. clear a b c x.
  assert (S' : 0 < A + B + C) by lra. clear S O D.
  destruct (Rtotal_order y ya) as [Ha|[Ha|Ha]]; destruct (Rtotal_order y yb) as [Hb|[Hb|Hb]]; destruct (Rtotal_order y yc) as [Hc|[Hc|Hc]];
  try (subst ya); try (subst yb); try (subst yc);
  try specialize (HA eq_refl eq_refl); try specialize (HB eq_refl eq_refl); try specialize (HC eq_refl eq_refl);
  unfold below;
  repeat match goal with
    | |- context [Rlt_dec ?u ?u] => let N := fresh in destruct (Rlt_dec u u) as [N|_]; [exfalso; exact (Rlt_irrefl _ N)|]
    | H : ?u < ?v |- context [Rlt_dec ?u ?v] => let N := fresh in destruct (Rlt_dec u v) as [_|N]; [|exfalso; exact (N H)]
    | H : ?v < ?u |- context [Rlt_dec ?u ?v] => let N := fresh in destruct (Rlt_dec u v) as [N|_]; [exfalso; exact (Rlt_asym _ _ H N)|]
    | H : ?u > ?v |- context [Rlt_dec ?u ?v] => let N := fresh in destruct (Rlt_dec u v) as [N|_]; [exfalso; exact (Rlt_asym _ _ H N)|]
    | H : ?v > ?u |- context [Rlt_dec ?u ?v] => let N := fresh in destruct (Rlt_dec u v) as [_|N]; [|exfalso; exact (N H)]
    end; cbn [negb andb];
  destruct (Rtotal_order A 0) as [SA|[SA|SA]]; destruct (Rtotal_order B 0) as [SB|[SB|SB]]; destruct (Rtotal_order C 0) as [SC|[SC|SC]];
  try (exfalso; lra);
  try (exfalso; try rewrite SA in H; try rewrite SB in H; try rewrite SC in H; match type of H with ?a * ?u + ?b * ?v + ?c * ?w = 0 => mul a u; mul b v; mul c w end; lra);
  repeat match goal with
    | H : ?u > 0 |- context [Rlt_dec 0 ?u] => destruct (Rlt_dec 0 u) as [_|N]; [|exfalso; apply N; exact H]
    | H : ?u > 0 |- context [Rlt_dec ?u 0] => destruct (Rlt_dec u 0) as [N|_]; [exfalso; exact (Rlt_asym _ _ H N)|]
    | H : ?u < 0 |- context [Rlt_dec 0 ?u] => destruct (Rlt_dec 0 u) as [N|_]; [exfalso; exact (Rlt_asym _ _ H N)|]
    | H : ?u < 0 |- context [Rlt_dec ?u 0] => destruct (Rlt_dec u 0) as [_|N]; [|exfalso; apply N; exact H]
    | H : ?u = 0 |- context [Rlt_dec 0 ?u] => destruct (Rlt_dec 0 u) as [N|_]; [exfalso; rewrite H in N; exact (Rlt_irrefl _ N)|]
    | H : ?u = 0 |- context [Rlt_dec ?u 0] => destruct (Rlt_dec u 0) as [N|_]; [exfalso; rewrite H in N; exact (Rlt_irrefl _ N)|]
    end; cbn; (split; [lia|split; [intro; first [lia | lra]|intros; first [reflexivity | lia | exfalso; lra]]]).
Qed.

(** Subdividing an edge does not change its crossings. *)
Definition inside (p m q : R * R) := exists t, 0 < t < 1 /\
  fst m = fst p + t * (fst q - fst p) /\ snd m = snd p + t * (snd q - snd p).
Lemma crossing_split : forall x p m q, inside p m q -> (crossing x p q = crossing x p m + crossing x m q)%Z.
Proof.
  intros x p m q [t [Ht [E1 E2]]].
  assert (O1 : area2 p m x = t * area2 p q x) by (unfold area2; rewrite E1, E2; ring).
  assert (O2 : area2 m q x = (1-t) * area2 p q x) by (unfold area2; rewrite E1, E2; ring).
  unfold crossing. rewrite O1, O2. set (A := area2 p q x). clearbody A.
  set (y := snd x) in *. set (yp := snd p) in *. set (yq := snd q) in *. set (ym := snd m) in *. clearbody y yp yq ym.
  assert (S1 : 0 < A -> 0 < t*A /\ 0 < (1-t)*A) by (intro; split; nra).
  assert (S2 : A < 0 -> t*A < 0 /\ (1-t)*A < 0) by (intro; split; nra).
  assert (S3 : A = 0 -> t*A = 0 /\ (1-t)*A = 0) by (intros ->; split; ring).
  assert (M : (yp <= ym <= yq) \/ (yq <= ym <= yp)) by (destruct (Rle_dec yp yq); [left|right]; split; nra).
  clear E1 E2 O1 O2 Ht. generalize dependent (t*A). generalize dependent ((1-t)*A). intros A2 A1 P N Z.
  unfold below.
  destruct (Rtotal_order A 0) as [L|[L|L]];
  [ specialize (N L) | specialize (Z L) | specialize (P L) ];
  (destruct (Rlt_dec 0 A); [try (exfalso; lra)|try (exfalso; lra)]);
  (destruct (Rlt_dec A 0); [try (exfalso; lra)|try (exfalso; lra)]);
  (destruct (Rlt_dec 0 A1); [try (exfalso; lra)|try (exfalso; lra)]);
  (destruct (Rlt_dec A1 0); [try (exfalso; lra)|try (exfalso; lra)]);
  (destruct (Rlt_dec 0 A2); [try (exfalso; lra)|try (exfalso; lra)]);
  (destruct (Rlt_dec A2 0); [try (exfalso; lra)|try (exfalso; lra)]);
  rewrite ?andb_false_r, ?andb_true_r; try reflexivity;
  destruct M as [M|M];
  (destruct (Rlt_dec y yp); [try (exfalso; lra)|try (exfalso; lra)]);
  (destruct (Rlt_dec y yq); [try (exfalso; lra)|try (exfalso; lra)]);
  (destruct (Rlt_dec y ym); [try (exfalso; lra)|try (exfalso; lra)]); reflexivity.
Qed.
