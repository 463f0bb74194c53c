(** Theorem 3.1 of the paper, repaired: "A PLC P can be refined so that the Delaunay
    tetrahedralization of its augmented vertex set conforms to P".

    [theorem_3_1_repaired]: for a finite simplicial complex K in space with admissible
    numbers (r, phi, alpha), the parameters of theory.md section 3, and ANY set of points
    placed by the rule, the diametral sphere of every T, S, R and C cell is empty: no
    point strictly inside, and no point off the cell's face inside or on it. This
    is the hypothesis of Lemma 1.2, closed off the plane (L18). What is not proved here
    (that such numbers and points exist, that the cells tile the faces, and that tiling
    and emptiness give conformity) is stated in Remaining.v. *)
From Coq Require Import Reals Lra Psatz List Classical.
From Confidel.lemmas Require Import Space.
From Confidel.theorem Require Import Complex Placement Separation OffFaceVertex OffFaceEdge InFace InFaceEdge.
Import ListNotations.
Open Scope R_scope.

Section Theorem31.
Variables (K : complex) (r phi beta d h alpha : R).

(** The cells of face v w z among the points P: centre c, corner p of the sphere. *)
Inductive cell (P : point_set) : vec -> vec -> vec -> vec -> vec -> Prop :=
| cell_T v w z c p : T_cell K r beta d v w z c p -> cell P v w z c p
| cell_S v w z t1 t2 c p : S_cell K r beta h v w z t1 t2 c p -> S_legal P r h v w z t1 t2 -> cell P v w z c p
| cell_R v w z x1 x2 c p : R_cell K r beta d h v w z x1 x2 c p -> R_legal P d h v w z x1 x2 -> cell P v w z c p
| cell_C v w z c p : C_cell K r beta d h v w z c p -> C_legal P v w z c p -> cell P v w z c p.

Hypothesis HK : simplicial K.
Hypothesis HF : features K r phi alpha.
Hypothesis HS : setting r phi beta d h alpha.

(** A point set placed by the rule: every point on its carrier, as Placement.placed says. *)
Definition placement (P : point_set) := forall t x, P t x -> has K t /\ placed r beta d t x.

Theorem theorem_3_1_repaired P : placement P ->
  forall v w z c p, cell P v w z c p ->
  forall t x, P t x ->
    ~ strictly_inside c p x /\ (~ incl (corners t) [v; w; z] -> 0 < power c p x).
Proof.
  intros HP v w z c p C t x Px. destruct (HP t x Px) as [Ht Pl].
  assert (G : (incl (corners t) [v; w; z] -> 0 <= power c p x) /\
              (~ incl (corners t) [v; w; z] -> 0 < power c p x)).
  { destruct C as [v w z c p T|v w z t1 t2 c p T L|v w z x1 x2 c p T L|v w z c p T L]; split; intros I.
    - apply (T_in_face K r phi beta d h alpha P HK HF HS HP v w z c p t); assumption.
    - apply (T_off_face K r phi beta d h alpha HK HF HS v w z c p t); assumption.
    - apply (S_in_face K r phi beta d h alpha P HK HF HS HP v w z t1 t2 c p t); assumption.
    - apply (S_off_face K r phi beta d h alpha HK HF HS v w z t1 t2 c p t); assumption.
    - apply (R_in_face K r phi beta d h alpha P HK HF HS HP v w z x1 x2 c p t); assumption.
    - apply (R_off_face K r phi beta d h alpha HK HF HS v w z x1 x2 c p t); assumption.
    - apply (L t); assumption.
    - apply (C_off_face K r phi beta d h alpha HK HF HS v w z c p t); assumption. }
  destruct G as [G1 G2]. split; [|exact G2].
  unfold strictly_inside. destruct (classic (incl (corners t) [v; w; z])) as [I|I].
  - specialize (G1 I). lra.
  - specialize (G2 I). lra.
Qed.
End Theorem31.
