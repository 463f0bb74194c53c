(* SPDX-License-Identifier: Apache-2.0 *)
(** * The theorem is not empty: an accepted certificate, a Delaunay subdivision of its points, a facet with points *)
From Coq Require Import ZArith List Reals Lra.
From Confidel.checker Require Import Space Statement Check Sound.
Import ListNotations.

(** A triangle in the plane z = 0 and a vertex above it; one cell; an edge that hangs from the triangle to that vertex. *)
Definition A := HPoint 0 0 0 1.
Definition B := HPoint 4 0 0 1.
Definition C := HPoint 0 4 0 1.
Definition D := HPoint 1 1 4 1.
Definition K := Complex [A; B; C; D] [(1, 2); (1, 3); (1, 4); (2, 3)]%positive
  [Facet 1 2 3 [(1, 2); (2, 3); (3, 1)] [] []]%positive.
Definition everywhere := Box (-9) 9 (-9) 9 (-9) 9.
Definition certificate_ := Certificate [] [[Cell 1 2 3 None everywhere]]%positive [A; B; C; D]
  [([], []); ([], []); ([], [everywhere]); ([], [])] 1 (Node everywhere (Leaf everywhere [1; 2]%positive) (Leaf everywhere [3; 4]%positive)).
Example accepted : check K certificate_ = true.
Proof. vm_compute. reflexivity. Qed.
(** The same cell clockwise. *)
Example refused : check K (Certificate [] [[Cell 1 3 2 None everywhere]]%positive [A; B; C; D]
  [([], []); ([], []); ([], [everywhere]); ([], [])] 1 (Node everywhere (Leaf everywhere [1; 2]%positive) (Leaf everywhere [3; 4]%positive))) = false.
Proof. vm_compute. reflexivity. Qed.

Open Scope R_scope.
Definition T : list simplex := [(real A, real B, real C, real D)].
Lemma real_one x y z : real (HPoint x y z 1) = Point (IZR x) (IZR y) (IZR z).
Proof. unfold real; cbn [hx hy hz hw]. f_equal; field. Qed.
Lemma T_delaunay : delaunay (all_points K certificate_) T.
Proof.
  unfold all_points, K, certificate_, T; cbn [c_vertices d_steiner map app]. unfold A, B, C, D. rewrite !real_one. split.
  - intros t v [<-|[]]. cbn [corner]. intros [H|[H|[H|H]]]; subst v; cbn; tauto.
  - intros t [<-|[]]. unfold solid, normal, dot, cross, minus; cbn. lra.
  - intros t [<-|[]]. exists (Point 2 2 (5/4)). intros u Hu.
    assert (E : forall w, corner (Point 0 0 0, Point 4 0 0, Point 0 4 0, Point 1 1 4) w -> dist2 (Point 2 2 (5/4)) w = 153/16).
    { cbn [corner]. intros w [->|[->|[->| ->]]]; unfold dist2, dot, minus; cbn; field. }
    split; [intros w Hw; rewrite !E by assumption; reflexivity|]. intros v Hv. rewrite E by assumption. rewrite (E v); [lra|]. cbn in *. intuition auto.
  - assert (vert : forall v, In v [Point 0 0 0; Point 4 0 0; Point 0 4 0; Point 1 1 4] -> in_simplex (Point 0 0 0, Point 4 0 0, Point 0 4 0, Point 1 1 4) v).
    { cbn. intros v [<-|[<-|[<-|[<-|[]]]]]; [exists 1, 0, 0, 0|exists 0, 1, 0, 0|exists 0, 0, 1, 0|exists 0, 0, 0, 1]; repeat split; try lra; unfold mix4; cbn; f_equal; ring. }
    intro x. split.
    + intro H. exists (Point 0 0 0, Point 4 0 0, Point 0 4 0, Point 1 1 4). split; [left; reflexivity|].
      induction H as [v Hv|x y s Hs _ (a1 & a2 & a3 & a4 & P1 & P2 & P3 & P4 & PS & ->) _ (b1 & b2 & b3 & b4 & Q1 & Q2 & Q3 & Q4 & QS & ->)]; [apply vert; exact Hv|].
      exists (a1 + s*(b1-a1)), (a2 + s*(b2-a2)), (a3 + s*(b3-a3)), (a4 + s*(b4-a4)).
      assert (G : forall u v, 0 <= u -> 0 <= v -> 0 <= u + s*(v-u)).
      { intros u v Hu Hv. replace (u + s*(v-u)) with ((1-s)*u + s*v) by ring. apply Rplus_le_le_0_compat; apply Rmult_le_pos; lra. }
      repeat (split; [apply G; assumption|]). split.
      * replace (a1+s*(b1-a1)+(a2+s*(b2-a2))+(a3+s*(b3-a3))+(a4+s*(b4-a4))) with ((1-s)*(a1+a2+a3+a4)+s*(b1+b2+b3+b4)) by ring. rewrite PS, QS. ring.
      * unfold towards, mix4; cbn. f_equal; ring.
    + intros (t & [<-|[]] & l & m & n & k & L & M & N & J & S & ->).
      set (V := [Point 0 0 0; Point 4 0 0; Point 0 4 0; Point 1 1 4]).
      assert (one : forall x w, 0 <= x -> 0 <= w -> x + w = 0 \/ 0 <= w / (x + w) <= 1).
      { intros x w Hx Hw. destruct (Req_dec (x+w) 0); [auto|right]. assert (I := Rinv_0_lt_compat (x+w) ltac:(lra)). split; [apply Rmult_le_pos; lra|].
        apply (Rmult_le_reg_r (x+w)); [lra|]. replace (w/(x+w)*(x+w)) with w by (field; lra). lra. }
      (* the hull is closed under mixing step by step: first the first two, then the third, then the fourth *)
      assert (H2 : l + m = 0 \/ hull V (towards (Point 0 0 0) (Point 4 0 0) (m/(l+m)))).
      { destruct (one l m L M) as [Z|Z]; [auto|right]. apply hull_towards; [exact Z| |]; apply hull_in; unfold V; cbn; tauto. }
      assert (H3 : l + m + n = 0 \/ exists p, hull V p /\ cx p * (l+m+n) = 4*m /\ cy p * (l+m+n) = 4*n /\ cz p = 0).
      { destruct (one (l+m) n ltac:(lra) N) as [Z|Z]; [auto|right]. destruct H2 as [H2|H2].
        - exists (Point 0 4 0). split; [apply hull_in; unfold V; cbn; tauto|]. cbn. repeat split; lra.
        - destruct (Req_dec (l+m) 0) as [Y|Y].
          + exists (Point 0 4 0). split; [apply hull_in; unfold V; cbn; tauto|]. cbn. repeat split; lra.
          + exists (towards (towards (Point 0 0 0) (Point 4 0 0) (m/(l+m))) (Point 0 4 0) (n/(l+m+n))). split.
            * apply hull_towards; [exact Z|exact H2|apply hull_in; unfold V; cbn; tauto].
            * assert (l+m+n <> 0) by lra. cbn. repeat split; field; lra. }
      destruct H3 as [H3|(p & Hp & E1 & E2 & E3)].
      * assert (l = 0) by lra. assert (m = 0) by lra. assert (n = 0) by lra. assert (k = 1) by lra. subst l m n k.
        replace (mix4 (Point 0 0 0) (Point 4 0 0) (Point 0 4 0) (Point 1 1 4) 0 0 0 1) with (Point 1 1 4) by (unfold mix4; cbn; f_equal; ring).
        apply hull_in; unfold V; cbn; tauto.
      * replace (mix4 (Point 0 0 0) (Point 4 0 0) (Point 0 4 0) (Point 1 1 4) l m n k) with (towards p (Point 1 1 4) k).
        -- apply hull_towards; [lra|exact Hp|apply hull_in; unfold V; cbn; tauto].
        -- replace (l+m+n) with (1-k) in * by lra. unfold towards, mix4; cbn. rewrite E3. f_equal; [|lra..]; lra.
  - intros t u x [<-|[]] [<-|[]] (l & m & n & k & L & M & N & J & S & E) _. exists l, m, n, k. cbn [corner]. tauto.
Qed.
Corollary conforming : conforms K T.
Proof. apply (check_sound K certificate_ accepted T T_delaunay). Qed.
