(* SPDX-License-Identifier: Apache-2.0 *)
(** * The check, executable: integers, positive numbers, lists and finite maps; no reals.

    Names of rules are those of docs/certificate-format.md section 5. Everything that is marked "witness" is computed by the driver,
    is trusted by nobody, and is tested here. Loops over lists are tail recursive; recursion is as deep as the tree or a number's bits. *)
From Coq Require Import ZArith List Bool FMapPositive.
From Confidel.checker Require Import Statement.
Import ListNotations.
Open Scope Z_scope.

(** Constants by name, so that extraction never has to spell an integer. *)
Definition zero : Z := 0.
Definition one : Z := 1.
Definition two : Z := 2.

(** ** Integer vectors *)
Record vec := Vec { vx : Z; vy : Z; vz : Z }.
Definition vdot a b := vx a * vx b + vy a * vy b + vz a * vz b.
Definition vsub a b := Vec (vx a - vx b) (vy a - vy b) (vz a - vz b).
Definition vadd a b := Vec (vx a + vx b) (vy a + vy b) (vz a + vz b).
Definition vscale k a := Vec (k * vx a) (k * vy a) (k * vz a).
Definition vcross a b := Vec (vy a * vz b - vz a * vy b) (vz a * vx b - vx a * vz b) (vx a * vy b - vy a * vx b).
Definition num p := Vec (hx p) (hy p) (hz p).

(** [relative w a p] = (r, k): the point p minus the point a/w is the vector r/(w k). *)
Definition relative (w : Z) (a : vec) (p : hpoint) : vec * Z :=
  if hw p =? w then (vsub (num p) a, one) else (vsub (vscale w (num p)) (vscale (hw p) a), hw p).

(** [common a b c] = (w, a', b', c'): the three points over one denominator. *)
Definition common (a b c : hpoint) : Z * vec * vec * vec :=
  if (hw a =? hw b) && (hw a =? hw c) then (hw a, num a, num b, num c)
  else (hw a * hw b * hw c, vscale (hw b * hw c) (num a), vscale (hw a * hw c) (num b), vscale (hw a * hw b) (num c)).

(** ** Spheres: through the point a/w, with centre (a + m/d)/w *)
Record sphere := Sphere { s_w : Z; s_a : vec; s_d : Z; s_m : vec }.

(** The power of [p], times a positive number. *)
Definition power (s : sphere) (p : hpoint) : Z :=
  let (r, k) := relative (s_w s) (s_a s) p in
  s_d s * vdot r r - two * k * vdot r (s_m s).

(** The smallest sphere through a, b, c: [u] = b - a, [v] = c - a, [n] = u x v, all in units of 1/w. *)
Definition smallest w a u v n : sphere :=
  Sphere w a (two * vdot n n) (vadd (vscale (vdot u u) (vcross v n)) (vscale (vdot v v) (vcross n u))).

(** Its centre moved by (t/h) times the facet's normal, which is [n]/[w2]. *)
Definition moved (s : sphere) (t h : Z) (n : vec) (w2 : Z) : sphere :=
  Sphere (s_w s) (s_a s) (s_d s * h * w2) (vadd (vscale (h * w2) (s_m s)) (vscale (s_d s * s_w s * t) n)).

(** The sphere with diameter from a/w to a/w + u/w. *)
Definition diametral w a u : sphere := Sphere w a two u.

(** ** Boxes (witnesses), over one denominator [g] > 0 *)
Record box := Box { lox : Z; hix : Z; loy : Z; hiy : Z; loz : Z; hiz : Z }.
Definition point_in_box g b p :=
  (hw p * lox b <=? g * hx p) && (g * hx p <=? hw p * hix b) &&
  (hw p * loy b <=? g * hy p) && (g * hy p <=? hw p * hiy b) &&
  (hw p * loz b <=? g * hz p) && (g * hz p <=? hw p * hiz b).
Definition box_in_box b c :=
  (lox b <=? lox c) && (hix c <=? hix b) && (loy b <=? loy c) && (hiy c <=? hiy b) && (loz b <=? loz c) && (hiz c <=? hiz b).
Definition apart b c :=
  (hix b <? lox c) || (hix c <? lox b) || (hiy b <? loy c) || (hiy c <? loy b) || (hiz b <? loz c) || (hiz c <? loz b).

(** The closed ball of [s] lies in the box: each of its six planes is at least a radius away from the centre, on the right side. *)
Definition ball_in_box g (s : sphere) (b : box) : bool :=
  let same := s_w s =? g in
  let f := if same then one else g in
  let r2 := f * f * vdot (s_m s) (s_m s) in
  let gap h a := if same then h - a else h * s_w s - g * a in
  let far e := (zero <=? e) && (r2 <=? e * e) in
  far (s_d s * gap (hix b) (vx (s_a s)) - f * vx (s_m s)) && far (f * vx (s_m s) - s_d s * gap (lox b) (vx (s_a s))) &&
  far (s_d s * gap (hiy b) (vy (s_a s)) - f * vy (s_m s)) && far (f * vy (s_m s) - s_d s * gap (loy b) (vy (s_a s))) &&
  far (s_d s * gap (hiz b) (vz (s_a s)) - f * vz (s_m s)) && far (f * vz (s_m s) - s_d s * gap (loz b) (vz (s_a s))).

(** ** Points and carriers *)
Inductive carrier := AtVertex | OnSegment (s : number) | OnFacet (f : number).
Definition points := PositiveMap.t (hpoint * carrier).
Definition set := PositiveMap.t unit.
Definition mem (k : number) (s : set) : bool := match PositiveMap.find k s with Some _ => true | None => false end.
Definition insert (k : number) (s : set) : set := PositiveMap.add k tt s.

(** [q] (witness) is the point [p], perhaps over another denominator. *)
Definition same_point (p q : hpoint) : bool :=
  (zero <? hw p) && (zero <? hw q) &&
  (hx p * hw q =? hx q * hw p) && (hy p * hw q =? hy q * hw p) && (hz p * hw q =? hz q * hw p).

Fixpoint load_vertices (l ws : list hpoint) (k : number) (m : points) : option (number * list hpoint * points) :=
  match l, ws with
  | [], _ => Some (k, ws, m)
  | p :: l', q :: ws' => if same_point p q then load_vertices l' ws' (Pos.succ k) (PositiveMap.add k (q, AtVertex) m) else None
  | _, _ => None end.
Definition is_steiner c := match c with AtVertex => false | _ => true end.
Fixpoint load_steiner (l : list (hpoint * carrier)) (ws : list hpoint) (k : number) (m : points) : option (number * points) :=
  match l, ws with
  | [], [] => Some (k, m)
  | (p, c) :: l', q :: ws' =>
      if same_point p q && is_steiner c then load_steiner l' ws' (Pos.succ k) (PositiveMap.add k (q, c) m) else None
  | _, _ => None end.

(** ** The tree of the points (witness) *)
Inductive tree := Leaf (b : box) (l : list number) | Node (b : box) (t u : tree).
Definition box_of t := match t with Leaf b _ => b | Node b _ _ => b end.
Fixpoint tree_ok (m : points) g (t : tree) : bool := match t with
  | Leaf b l => forallb (fun k => match PositiveMap.find k m with Some (p, _) => point_in_box g b p | None => false end) l
  | Node b t u => box_in_box b (box_of t) && box_in_box b (box_of u) && tree_ok m g t && tree_ok m g u end.
Fixpoint tree_numbers (t : tree) (s : set) : set := match t with
  | Leaf _ l => fold_left (fun s k => insert k s) l s
  | Node _ t u => tree_numbers u (tree_numbers t s) end.
(** numbers [k], [k]+1, ... (one for each element of the list) are in [s] *)
Fixpoint all_in {A} (l : list A) (k : number) (s : set) : bool :=
  match l with [] => true | _ :: l' => mem k s && all_in l' (Pos.succ k) s end.
(** [f] holds for all points of the tree, but those in boxes apart from [q] *)
Fixpoint query (f : number -> bool) (q : box) (t : tree) : bool :=
  if apart q (box_of t) then true
  else match t with Leaf _ l => forallb f l | Node _ t u => query f q t && query f q u end.

(** ** Segments and their points in order *)
Definition edge := (number * number)%type.
Definition swap (e : edge) : edge := (snd e, fst e).
(** Folds over the edges a - m1 - m2 ... - b. *)
Fixpoint fold_links {A} (f : A -> edge -> A) (a : number) (ms : list number) (b : number) (x : A) : A :=
  match ms with [] => f x (a, b) | m :: ms' => fold_links f m ms' b (f x (a, m)) end.
Fixpoint all_links (f : edge -> bool) (a : number) (ms : list number) (b : number) : bool :=
  match ms with [] => f (a, b) | m :: ms' => f (a, m) && all_links f m ms' b end.

(** m lies strictly between p and q *)
Definition between (p m q : hpoint) : bool :=
  let '(_, p', m', q') := common p m q in
  let u := vsub m' p' in let v := vsub q' m' in let c := vcross u v in
  (vx c =? zero) && (vy c =? zero) && (vz c =? zero) && (zero <? vdot u v).
Definition number_eqb := Pos.eqb.
Fixpoint chain_ok (m : points) (s : number) (a : number) (ms : list number) (b : number) : bool :=
  match ms with
  | [] => true
  | k :: ms' =>
      match PositiveMap.find a m, PositiveMap.find k m, PositiveMap.find b m with
      | Some (p, _), Some (x, OnSegment s'), Some (q, _) =>
          number_eqb s s' && between p x q && chain_ok m s k ms' b
      | _, _, _ => false end
  end.
Definition is_vertex (m : points) k := match PositiveMap.find k m with Some (_, AtVertex) => true | _ => false end.

(** [g_ms]: the points carried by the segment, in order; [g_boxes]: one box for each subsegment if the segment hangs. *)
Record segment := Segment { g_a : number; g_b : number; g_ms : list number; g_boxes : list box }.
Definition segments := PositiveMap.t segment.
Definition distinct_places (m : points) a b :=
  match PositiveMap.find a m, PositiveMap.find b m with
  | Some (p, _), Some (q, _) => negb ((hx p * hw q =? hx q * hw p) && (hy p * hw q =? hy q * hw p) && (hz p * hw q =? hz q * hw p))
  | _, _ => false end.
Fixpoint load_segments (m : points) (l : list edge) (ws : list (list number * list box)) (k : number) (sm : segments) : option segments :=
  match l, ws with
  | [], [] => Some sm
  | (a, b) :: l', (ms, bs) :: ws' =>
      if is_vertex m a && is_vertex m b && distinct_places m a b && chain_ok m k a ms b
      then load_segments m l' ws' (Pos.succ k) (PositiveMap.add k (Segment a b ms bs) sm) else None
  | _, _ => None end.

(** Pairs of vertices to segments: for each first vertex its (second vertex, segment). *)
Definition pairs := PositiveMap.t (list (number * number)).
Definition get {A} (k : number) (t : PositiveMap.t (list A)) : list A := match PositiveMap.find k t with Some l => l | None => [] end.
Fixpoint load_pairs (l : list edge) (k : number) (t : pairs) : pairs :=
  match l with [] => t | (a, b) :: l' => load_pairs l' (Pos.succ k) (PositiveMap.add a ((b, k) :: get a t) t) end.
Fixpoint assoc (b : number) (l : list (number * number)) : option number :=
  match l with [] => None | (c, k) :: l' => if number_eqb b c then Some k else assoc b l' end.
(** the segment from a to b, exactly in this direction *)
Definition directed (sm : segments) (t : pairs) (a b : number) : option (number * segment) :=
  match assoc b (get a t) with
  | Some k => match PositiveMap.find k sm with
      | Some g => if number_eqb a (g_a g) && number_eqb b (g_b g) then Some (k, g) else None
      | None => None end
  | None => None end.
(** ... or in either; true: as asked for *)
Definition segment_between sm t a b : option (number * segment * bool) :=
  match directed sm t a b with
  | Some (k, g) => Some (k, g, true)
  | None => match directed sm t b a with Some (k, g) => Some (k, g, false) | None => None end end.

(** ** Sets of directed edges *)
Definition edges := PositiveMap.t (list number).
Definition has (s : edges) (e : edge) : bool := existsb (number_eqb (snd e)) (get (fst e) s).
Definition add_edge (s : option edges) (e : edge) : option edges :=
  match s with
  | None => None
  | Some s => if has s e then None else Some (PositiveMap.add (fst e) (snd e :: get (fst e) s) s) end.

(** ** Facets *)
Record cell := Cell { t_a : number; t_b : number; t_c : number; t_offset : option (Z * Z); t_box : box }.
(** The plane through o/w with normal n/w2. *)
Record plane := Plane { p_w : Z; p_o : vec; p_n : vec; p_w2 : Z }.
Definition plane_of (m : points) F : option plane :=
  match PositiveMap.find (f_i F) m, PositiveMap.find (f_j F) m, PositiveMap.find (f_k F) m with
  | Some (p, AtVertex), Some (q, AtVertex), Some (r, AtVertex) =>
      let '(w, a, b, c) := common p q r in Some (Plane w a (vcross (vsub b a) (vsub c a)) (w * w))
  | _, _, _ => None end.
Definition on_plane (pl : plane) (p : hpoint) : bool := vdot (p_n pl) (fst (relative (p_w pl) (p_o pl) p)) =? zero.

(** What a facet's cells are tested against: its number, plane, vertices and segments. *)
Record context := Context { x_number : number; x_plane : plane; x_vertices : set; x_segments : set }.
Definition add_pair sm t (x : option (set * set)) (e : edge) : option (set * set) :=
  match x with
  | None => None
  | Some (vs, ss) => match segment_between sm t (fst e) (snd e) with
      | Some (k, _, _) => Some (insert (fst e) (insert (snd e) vs), insert k ss)
      | None => None end end.
Definition context_of (m : points) sm t (k : number) F : option context :=
  match plane_of m F with
  | None => None
  | Some pl =>
      match fold_left (add_pair sm t) (f_inner F) (fold_left (add_pair sm t) (f_boundary F) (Some (PositiveMap.empty unit, PositiveMap.empty unit))) with
      | None => None
      | Some (vs, ss) => Some (Context k pl (fold_left (fun vs v => insert v vs) (f_isolated F) vs) ss) end end.

(** Rule [cell]: who may be a corner. *)
Definition corner_ok (x : context) (k : number) (c : carrier) : bool := match c with
  | AtVertex => mem k (x_vertices x)
  | OnSegment s => mem s (x_segments x)
  | OnFacet f => number_eqb f (x_number x) end.
(** The edge u v lies on a segment of the facet: both ends are that segment's vertices or points carried by it. *)
Definition is_end (sm : segments) s v := match PositiveMap.find s sm with Some g => number_eqb v (g_a g) || number_eqb v (g_b g) | None => false end.
Definition in_context (x : context) (o : option (number * segment)) := match o with Some (s, _) => mem s (x_segments x) | None => false end.
Definition lies_on (m : points) sm t (x : context) (u v : number) : bool :=
  match PositiveMap.find u m, PositiveMap.find v m with
  | Some (_, OnSegment s), Some (_, OnSegment s') => number_eqb s s' && mem s (x_segments x)
  | Some (_, OnSegment s), Some (_, AtVertex) => mem s (x_segments x) && is_end sm s v
  | Some (_, AtVertex), Some (_, OnSegment s) => mem s (x_segments x) && is_end sm s u
  | Some (_, AtVertex), Some (_, AtVertex) => in_context x (directed sm t u v) || in_context x (directed sm t v u)
  | _, _ => false end.

(** A cell with its corners over one denominator. *)
Record located := Located { l_w : Z; l_a : vec; l_b : vec; l_c : vec }.
Definition locate (m : points) (c : cell) : option located :=
  match PositiveMap.find (t_a c) m, PositiveMap.find (t_b c) m, PositiveMap.find (t_c c) m with
  | Some (p, _), Some (q, _), Some (r, _) => let '(w, a, b, d) := common p q r in Some (Located w a b d)
  | _, _, _ => None end.
Definition cell_sphere (pl : plane) (c : cell) (l : located) : sphere :=
  let u := vsub (l_b l) (l_a l) in let v := vsub (l_c l) (l_a l) in
  let s := smallest (l_w l) (l_a l) u v (vcross u v) in
  match t_offset c with None => s | Some (t, h) => moved s t h (p_n pl) (p_w2 pl) end.
(** Rule [cell]: corners allowed, in the plane, not collinear, counter-clockwise. *)
Definition corner_in (m : points) x k := match PositiveMap.find k m with
  | Some (p, c) => corner_ok x k c && on_plane (x_plane x) p | None => false end.
Definition cell_shape (m : points) (x : context) (c : cell) : bool :=
  corner_in m x (t_a c) && corner_in m x (t_b c) && corner_in m x (t_c c) &&
  match locate m c with
  | Some l => zero <? vdot (vcross (vsub (l_b l) (l_a l)) (vsub (l_c l) (l_a l))) (p_n (x_plane x))
  | None => false end &&
  match t_offset c with Some (_, h) => zero <? h | None => true end.

(** Rule [tie]: p is not strictly on the other side of u v (over w) from the cell, if the edge lies on a segment. *)
Definition side (n : vec) w u v p : bool := zero <=? vdot n (vcross (vsub v u) (fst (relative w u p))).
Definition tie_ok (m : points) sm t (x : context) (c : cell) (l : located) (p : hpoint) : bool :=
  let n := p_n (x_plane x) in
  (negb (lies_on m sm t x (t_a c) (t_b c)) || side n (l_w l) (l_a l) (l_b l) p) &&
  (negb (lies_on m sm t x (t_b c) (t_c c)) || side n (l_w l) (l_b l) (l_c l) p) &&
  (negb (lies_on m sm t x (t_c c) (t_a c)) || side n (l_w l) (l_c l) (l_a l) p).
Definition is_corner (c : cell) k := number_eqb k (t_a c) || number_eqb k (t_b c) || number_eqb k (t_c c).
(** Rules [emptiness] and [tie] for one cell and one point. *)
Inductive verdict := Fine | Inside | Tied.
Definition judge (m : points) sm t (x : context) (c : cell) (l : located) (s : sphere) (k : number) : verdict :=
  if is_corner c k then Fine   (* its power is zero: proved *)
  else match PositiveMap.find k m with
  | None => Inside
  | Some (p, _) =>
      let q := power s p in
      if zero <? q then Fine
      else if (q =? zero) && on_plane (x_plane x) p
      then if tie_ok m sm t x c l p then Fine else Tied
      else Inside end.
Definition fine v := match v with Fine => true | _ => false end.
Definition cell_ok (m : points) sm t (tr : tree) g (x : context) (c : cell) : bool :=
  cell_shape m x c &&
  match locate m c with
  | None => false
  | Some l => let s := cell_sphere (x_plane x) c l in
      ball_in_box g s (t_box c) && query (fun k => fine (judge m sm t x c l s k)) (t_box c) tr end.

(** Rule [tiling]. *)
Definition add_cell (s : option edges) (c : cell) : option edges :=
  add_edge (add_edge (add_edge s (t_a c, t_b c)) (t_b c, t_c c)) (t_c c, t_a c).
Definition add_boundary sm t (s : option edges) (e : edge) : option edges :=
  match segment_between sm t (fst e) (snd e) with
  | Some (_, g, true) => fold_links add_edge (g_a g) (g_ms g) (g_b g) s
  | Some (_, g, false) => fold_links (fun s e => add_edge s (swap e)) (g_a g) (g_ms g) (g_b g) s
  | None => None end.
Definition edge_paired (E B : edges) (e : edge) : bool := xorb (has E (swap e)) (has B e).
Definition cell_paired E B c := edge_paired E B (t_a c, t_b c) && edge_paired E B (t_b c, t_c c) && edge_paired E B (t_c c, t_a c).
Definition covers sm t (f : edge -> bool) (e : edge) : bool :=
  match segment_between sm t (fst e) (snd e) with
  | Some (_, g, true) => all_links f (g_a g) (g_ms g) (g_b g)
  | Some (_, g, false) => all_links (fun e => f (swap e)) (g_a g) (g_ms g) (g_b g)
  | None => false end.
Definition tiling_ok sm t F (cs : list cell) : bool :=
  match fold_left add_cell cs (Some (PositiveMap.empty _)), fold_left (add_boundary sm t) (f_boundary F) (Some (PositiveMap.empty _)) with
  | Some E, Some B =>
      forallb (cell_paired E B) cs &&
      forallb (covers sm t (has E)) (f_boundary F) &&
      forallb (covers sm t (fun e => has E e || has E (swap e))) (f_inner F) &&
      forallb (fun v => match get v E with [] => false | _ => true end) (f_isolated F) &&
      match cs with [] => false | _ => true end
  | _, _ => false end.

(** Rule [complex], as far as it concerns the facet's plane. *)
Definition vertex_on_plane (m : points) pl k := is_vertex m k && match PositiveMap.find k m with Some (p, _) => on_plane pl p | None => false end.
Definition facet_vertices_ok (m : points) pl F : bool :=
  forallb (fun e => vertex_on_plane m pl (fst e) && vertex_on_plane m pl (snd e)) (f_boundary F) &&
  forallb (fun e => vertex_on_plane m pl (fst e) && vertex_on_plane m pl (snd e)) (f_inner F) &&
  forallb (vertex_on_plane m pl) (f_isolated F).

Definition facet_ok (m : points) sm t (tr : tree) g (k : number) F (cs : list cell) : bool :=
  match context_of m sm t k F with
  | None => false
  | Some x => facet_vertices_ok m (x_plane x) F && tiling_ok sm t F cs && forallb (cell_ok m sm t tr g x) cs end.
Fixpoint facets_ok m sm t tr g (k : number) (Fs : list facet) (cs : list (list cell)) : bool :=
  match Fs, cs with
  | [], [] => true
  | F :: Fs', c :: cs' => facet_ok m sm t tr g k F c && facets_ok m sm t tr g (Pos.succ k) Fs' cs'
  | _, _ => false end.

(** Rule [hanging]: (x-a).(x-b) > 0 is a positive power with respect to the sphere with diameter a b. *)
Definition subsegment_ok (m : points) (tr : tree) g (a b : number) (q : box) : bool :=
  match PositiveMap.find a m, PositiveMap.find b m with
  | Some (p, _), Some (p', _) =>
      let '(w, u, v, _) := common p p' p in
      let s := diametral w u (vsub v u) in
      ball_in_box g s q &&
      query (fun k => if number_eqb k a || number_eqb k b then true
                      else match PositiveMap.find k m with Some (x, _) => zero <? power s x | None => false end) q tr
  | _, _ => false end.
Fixpoint hanging_ok m tr g (a : number) (ms : list number) (b : number) (qs : list box) : bool :=
  match ms, qs with
  | [], [q] => subsegment_ok m tr g a b q
  | k :: ms', q :: qs' => subsegment_ok m tr g a k q && hanging_ok m tr g k ms' b qs'
  | _, _ => false end.
(** segments that occur in a facet *)
Definition use sm t (s : set) (e : edge) : set :=
  match segment_between sm t (fst e) (snd e) with Some (k, _, _) => insert k s | None => s end.
Definition used sm t (Fs : list facet) : set :=
  fold_left (fun s F => fold_left (use sm t) (f_inner F) (fold_left (use sm t) (f_boundary F) s)) Fs (PositiveMap.empty unit).
Fixpoint segments_ok m tr g sm (u : set) {A} (l : list A) (k : number) : bool :=
  match l with
  | [] => true
  | _ :: l' =>
      (mem k u || match PositiveMap.find k sm with
         | Some s => hanging_ok m tr g (g_a s) (g_ms s) (g_b s) (g_boxes s) | None => false end)
      && segments_ok m tr g sm u l' (Pos.succ k) end.

(** ** The whole *)
Record certificate := Certificate {
  d_steiner : list (hpoint * carrier);             (** [q] lines *)
  d_cells : list (list cell);                      (** [t] lines, facet by facet *)
  d_points : list hpoint;                          (** witness: all points, over a common denominator where there is a small one *)
  d_segments : list (list number * list box);      (** witness: each segment's points in order; boxes for hanging ones *)
  d_scale : Z;                                     (** witness: the denominator of the boxes *)
  d_tree : tree }.                                 (** witness *)

Definition check (K : complex) (C : certificate) : bool :=
  match load_vertices (c_vertices K) (d_points C) 1%positive (PositiveMap.empty _) with
  | None => false
  | Some (k, ws, m0) =>
    match load_steiner (d_steiner C) ws k m0 with
    | None => false
    | Some (_, m) =>
      match load_segments m (c_segments K) (d_segments C) 1%positive (PositiveMap.empty _) with
      | None => false
      | Some sm =>
        let t := load_pairs (c_segments K) 1%positive (PositiveMap.empty _) in
        let g := d_scale C in let tr := d_tree C in
        let s := tree_numbers tr (PositiveMap.empty unit) in
        (zero <? g) && tree_ok m g tr && all_in (c_vertices K) 1%positive s && all_in (d_steiner C) k s &&
        facets_ok m sm t tr g 1%positive (c_facets K) (d_cells C) &&
        segments_ok m tr g sm (used sm t (c_facets K)) (c_segments K) 1%positive
      end end end.
