(* SPDX-License-Identifier: Apache-2.0 *)
(* From what was read to what the check takes (trusted: [prepare]); the rules that the theorem does not need; and the name of the rule
   that is violated when the check says no (only for the reader of the message). *)
module Integer = Z
open Check
module Z = Integer

exception Rejected = Extras.Rejected

let reject = Extras.reject

type state = {
  complex : complex;
  key : int -> number;
  given : hpoint array; (* all points as read *)
  g : Z.t;
  points : hpoint array; (* the same over a common denominator *)
  table : points;
  segment_of : (int * int, int) Hashtbl.t;
  chains : int list array; (* for each segment the points it carries *)
  vertices : int;
  coplanar : bool;
}

let rev_map_array f a = Array.fold_right (fun x acc -> f x :: acc) a []

(* The trusted part: the complex and the Steiner points, literally. *)
let facet key (f : Reader.facet) : facet =
  let pair (a, b) = (key a, key b) in
  let i, j, k = f.corners in
  { f_i = key i; f_j = key j; f_k = key k; f_boundary = rev_map_array pair f.boundary; f_inner = rev_map_array pair f.inner;
    f_isolated = rev_map_array key f.isolated }

let steiner key (c : Reader.certificate) =
  rev_map_array (fun (p, carrier) ->
      (Witness.hpoint p, match carrier with Reader.Segment s -> OnSegment (key s) | Reader.Facet f -> OnFacet (key f))) c.steiner

let all_coplanar points =
  (* the rank of the differences, exactly *)
  let n = Array.length points in
  let diff i =
    let p = points.(0) and q = points.(i) in
    { vx = Z.sub (Z.mul q.hx p.hw) (Z.mul p.hx q.hw); vy = Z.sub (Z.mul q.hy p.hw) (Z.mul p.hy q.hw); vz = Z.sub (Z.mul q.hz p.hw) (Z.mul p.hz q.hw) } in
  let zero v = Z.sign v.vx = 0 && Z.sign v.vy = 0 && Z.sign v.vz = 0 in
  let cross a b = { vx = Z.sub (Z.mul a.vy b.vz) (Z.mul a.vz b.vy); vy = Z.sub (Z.mul a.vz b.vx) (Z.mul a.vx b.vz); vz = Z.sub (Z.mul a.vx b.vy) (Z.mul a.vy b.vx) } in
  let dot a b = Z.add (Z.mul a.vx b.vx) (Z.add (Z.mul a.vy b.vy) (Z.mul a.vz b.vz)) in
  let rec first i p = if i >= n then None else let d = diff i in if p d then Some (i, d) else first (i + 1) p in
  match first 1 (fun d -> not (zero d)) with
  | None -> true
  | Some (i, u) -> (
      match first i (fun d -> not (zero (cross u d))) with
      | None -> true
      | Some (j, v) -> let n = cross u v in first j (fun d -> Z.sign (dot n d) <> 0) = None)

let prepare (c : Reader.certificate) =
  let plc = c.plc in
  let vertices = Array.length plc.vertices in
  let given = Array.append (Array.map Witness.hpoint plc.vertices) (Array.map (fun (p, _) -> Witness.hpoint p) c.steiner) in
  let size = Array.fold_left max (Array.length given) [| Array.length plc.segments; Array.length plc.facets |] in
  let key = Witness.keys size in
  let complex = {
    c_vertices = rev_map_array Witness.hpoint plc.vertices;
    c_segments = rev_map_array (fun (a, b) -> (key a, key b)) plc.segments;
    c_facets = rev_map_array (facet key) plc.facets } in
  let g, points = Witness.scale given in
  let ws = Array.to_list points in
  let table =
    match load_vertices complex.c_vertices ws XH PositiveMap.empty with
    | None -> failwith "load_vertices"
    | Some ((k, ws), m) -> ( match load_steiner (steiner key c) ws k m with None -> failwith "load_steiner" | Some (_, m) -> m) in
  let segment_of = Hashtbl.create (2 * Array.length plc.segments) in
  Array.iteri (fun s e -> Hashtbl.replace segment_of e s) plc.segments;
  let carried = Array.make (Array.length plc.segments) [] in
  Array.iteri (fun i (_, carrier) -> match carrier with Reader.Segment s -> carried.(s) <- (vertices + i) :: carried.(s) | Reader.Facet _ -> ()) c.steiner;
  let chains = Array.mapi (fun s l -> Witness.chain points (fst plc.segments.(s)) l) carried in
  { complex; key; given; g; points; table; segment_of; chains; vertices; coplanar = plc.dimension = 3 && all_coplanar points }

let holds = Extras.holds

(* the violation with the smallest line *)
type worst = { mutable at : (int * string) option }

let note w line fmt = Printf.ksprintf (fun what -> match w.at with Some (l, _) when l <= line -> () | _ -> w.at <- Some (line, what)) fmt
let settle rule w = match w.at with None -> () | Some (line, what) -> raise (Rejected (rule, line, what))

let hash (c : Reader.certificate) =
  if c.digest <> c.digest_found then reject "hash" c.end_line "digest";
  holds "hash" 1 "digest"

let find_segment s (a, b) = Hashtbl.find_opt s.segment_of (if a < b then (a, b) else (b, a))
let plane s f = plane_of s.table (facet s.key f)

(* The line of the certificate at which its complex and a given one differ, byte for byte. *)
let difference (plc : Reader.plc) text given =
  let block = plc.last - plc.first and size = String.length given in
  let same = ref 0 and line = ref 2 in
  while !same < block && !same < size && text.[plc.first + !same] = given.[!same] do
    if given.[!same] = '\n' then incr line;
    incr same
  done;
  if !same < block then Some !line else if !same < size then Some (!line - 1) else None

let complex s (c : Reader.certificate) text given =
  let plc = c.plc in
  let w = { at = None } in
  (match Option.bind given (difference plc text) with Some line -> note w line "other-complex" | None -> ());
  Array.iteri (fun n (f : Reader.facet) ->
      let occurs = Hashtbl.create 64 and first = Hashtbl.create 64 in
      let occur line v = Hashtbl.replace occurs v (); if not (Hashtbl.mem first v) then Hashtbl.replace first v line in
      Array.iteri (fun i (a, b) -> occur (f.b_line + i) a; occur (f.b_line + i) b) f.boundary;
      Array.iteri (fun i (a, b) -> occur (f.c_line + i) a; occur (f.c_line + i) b) f.inner;
      let edged = Hashtbl.copy occurs in
      Array.iteri (fun i a -> if Hashtbl.mem edged a then note w (f.p_line + i) "facet-%d-vertex-%d-not-isolated" n a; occur (f.p_line + i) a) f.isolated;
      let i, j, k = f.corners in
      (match plane s f with
      | None -> note w f.f_line "facet-%d" n
      | Some pl ->
          if Z.sign pl.p_n.vx = 0 && Z.sign pl.p_n.vy = 0 && Z.sign pl.p_n.vz = 0 then note w f.f_line "facet-%d-collinear" n
          else begin
            if plc.dimension = 2 && Z.sign pl.p_n.vz < 0 then note w f.f_line "facet-%d-clockwise" n;
            Hashtbl.iter (fun v line -> if not (on_plane pl s.points.(v)) then note w line "facet-%d-vertex-%d" n v) first
          end);
      List.iter (fun v -> if not (Hashtbl.mem occurs v) then note w f.f_line "facet-%d-vertex-%d" n v) [ i; j; k ];
      let edges = Hashtbl.create 64 and balance = Hashtbl.create 64 in
      let add v d = Hashtbl.replace balance v (d + Option.value ~default:0 (Hashtbl.find_opt balance v)) in
      Array.iteri (fun i (a, b) ->
          if a = b || find_segment s (a, b) = None then note w (f.b_line + i) "facet-%d-edge-%d-%d-no-segment" n a b;
          if Hashtbl.mem edges (b, a) then note w (f.b_line + i) "facet-%d-edge-%d-%d-both-directions" n a b;
          Hashtbl.replace edges (a, b) ();
          add a 1; add b (-1)) f.boundary;
      Hashtbl.iter (fun v d -> if d <> 0 then note w (Hashtbl.find first v) "facet-%d-vertex-%d-unbalanced" n v) balance;
      Array.iteri (fun i (a, b) ->
          if find_segment s (a, b) = None then note w (f.c_line + i) "facet-%d-constraint-%d-%d-no-segment" n a b;
          if Hashtbl.mem edges (a, b) || Hashtbl.mem edges (b, a) then note w (f.c_line + i) "facet-%d-constraint-%d-%d-on-boundary" n a b) f.inner)
    plc.facets;
  settle "complex" w;
  holds "complex" (Array.length plc.facets) "facets"

let line_of_point s (c : Reader.certificate) i = if i < s.vertices then c.plc.v_line + i else c.q_line + i - s.vertices

module Points = Hashtbl.Make (struct
  type t = hpoint
  let equal p q = Z.equal p.hx q.hx && Z.equal p.hy q.hy && Z.equal p.hz q.hz && Z.equal p.hw q.hw
  let hash p = (((((Z.hash p.hx * 65599) + Z.hash p.hy) * 65599) + Z.hash p.hz) * 65599) + Z.hash p.hw
end)

(* Every point has one spelling (the reader enforces it), so equal points are equal quadruples. *)
let distinct s c =
  let seen = Points.create (Array.length s.given) in
  Array.iteri (fun i p ->
      (match Points.find_opt seen p with Some j -> reject "distinct" (line_of_point s c i) "point-%d-point-%d" i j | None -> ());
      Points.replace seen p i) s.given;
  holds "distinct" (Array.length s.given) "points"

let carrier s (c : Reader.certificate) =
  let planes = Array.map (plane s) c.plc.facets in
  let corner_of = Array.make (Array.length s.points) [] in
  Array.iter (fun (t : Reader.cell) ->
      List.iter (fun v -> if v >= s.vertices && not (List.mem t.facet corner_of.(v)) then corner_of.(v) <- t.facet :: corner_of.(v)) [ t.a; t.b; t.c ]) c.cells;
  Array.iteri (fun i (_, carrier) ->
      let n = s.vertices + i in
      let line = c.q_line + i in
      match carrier with
      | Reader.Segment g ->
          let a, b = c.plc.segments.(g) in
          if not (between s.points.(a) s.points.(n) s.points.(b)) then reject "carrier" line "point-%d-segment-%d" n g
      | Reader.Facet f ->
          (match planes.(f) with Some pl when on_plane pl s.points.(n) -> () | _ -> reject "carrier" line "point-%d-facet-%d" n f);
          if not (List.mem f corner_of.(n)) then reject "carrier" line "point-%d-in-no-cell" n) c.steiner;
  holds "carrier" (Array.length c.steiner) "Steiner points"

(* ---- the certificate with its witnesses ---- *)

let cell_of s (t : Reader.cell) t_box = { t_a = s.key t.a; t_b = s.key t.b; t_c = s.key t.c; t_offset = t.offset; t_box }

let hanging_segments (c : Reader.certificate) s =
  let used = Array.make (Array.length c.plc.segments) false in
  Array.iter (fun (f : Reader.facet) ->
      let use e = match find_segment s e with Some g -> used.(g) <- true | None -> () in
      Array.iter use f.boundary; Array.iter use f.inner) c.plc.facets;
  used

let certificate s (c : Reader.certificate) =
  let planes = Array.map (plane s) c.plc.facets in
  let cells = Array.make (Array.length c.plc.facets) [] in
  for i = Array.length c.cells - 1 downto 0 do
    let t = c.cells.(i) in
    let bare = cell_of s t Witness.nowhere in
    let t_box = match (planes.(t.facet), locate s.table bare) with
      | Some pl, Some l -> Witness.sphere_box s.g (cell_sphere pl bare l)
      | _ -> Witness.nowhere in
    cells.(t.facet) <- { bare with t_box } :: cells.(t.facet)
  done;
  let used = hanging_segments c s in
  let segments = Array.mapi (fun g (a, b) ->
      let ms = s.chains.(g) in
      let boxes =
        if used.(g) then []
        else
          let rec go acc a = function
            | [] -> List.rev (Witness.subsegment_box s.g s.points.(a) s.points.(b) :: acc)
            | m :: ms -> go (Witness.subsegment_box s.g s.points.(a) s.points.(m) :: acc) m ms in
          go [] a ms in
      (List.rev (List.rev_map s.key ms), boxes)) c.plc.segments in
  { d_steiner = steiner s.key c; d_cells = Array.to_list cells; d_points = Array.to_list s.points; d_segments = Array.to_list segments;
    d_scale = s.g; d_tree = Witness.tree s.g s.key s.points }

(* Section 3: the records of a hanging segment are its subsegments in order. The check has proved the subsegments themselves. *)
let hanging_records s (c : Reader.certificate) =
  let used = hanging_segments c s in
  let w = { at = None } in
  let groups = Array.make (Array.length c.plc.segments) [] in
  for n = Array.length c.hanging - 1 downto 0 do
    let g, a, b = c.hanging.(n) in
    groups.(g) <- (n, a, b) :: groups.(g)
  done;
  Array.iteri (fun g (first, last) ->
      if used.(g) then List.iter (fun (n, _, _) -> note w (c.h_line + n) "subsegment-%d-segment-%d-not-hanging" n g) groups.(g)
      else begin
        (* [ahead]: what is still to come after [a]; [line]: of the last record *)
        let rec go line a ahead = function
          | [] -> if ahead <> [] then note w line "segment-%d-not-covered" g
          | (n, a', b') :: rest when a' = a && ahead <> [] && List.hd ahead = b' -> go (c.h_line + n) b' (List.tl ahead) rest
          | (n, a', b') :: _ ->
              let line = c.h_line + n in
              if a' <> a then note w line "subsegment-%d-point-%d-not-next" n a'
              else if not (b' = first || b' = last || List.mem b' s.chains.(g)) then note w line "subsegment-%d-point-%d-not-on-segment" n b'
              else if not (List.mem b' ahead) then note w line "subsegment-%d-point-%d-not-forward" n b'
              else note w line "subsegment-%d-point-%d" n (List.hd ahead) in
        go (c.plc.s_line + g) first (List.rev (last :: List.rev s.chains.(g))) groups.(g)
      end) c.plc.segments;
  settle "hanging" w;
  holds "hanging" (Array.length c.hanging) "records"

(* ---- which rule? Only called when the check has said no ---- *)

let edge_list (t : Reader.cell) = [ (t.a, t.b); (t.b, t.c); (t.c, t.a) ]

let tiling s (c : Reader.certificate) =
  let w = { at = None } in
  let facets = Array.length c.plc.facets in
  let edges = Array.init facets (fun _ -> Hashtbl.create 64) in
  let corners = Array.init facets (fun _ -> Hashtbl.create 64) in
  Array.iteri (fun i (t : Reader.cell) ->
      List.iter (fun e ->
          Hashtbl.replace corners.(t.facet) (fst e) ();
          let before = match Hashtbl.find_opt edges.(t.facet) e with Some (n, _) -> n | None -> 0 in
          if before > 0 then note w (c.t_line + i) "cell-%d-edge-%d-%d-twice" i (fst e) (snd e);
          Hashtbl.replace edges.(t.facet) e (before + 1, i)) (edge_list t)) c.cells;
  Array.iteri (fun n (f : Reader.facet) ->
      let e = edges.(n) in
      if Hashtbl.length e = 0 then note w f.f_line "facet-%d-no-cell" n;
      let left = Hashtbl.create 64 in
      let times edge = match Hashtbl.find_opt e edge with Some (n, _) -> n | None -> 0 in
      Hashtbl.iter (fun (a, b) (n, last) -> if n > times (b, a) then Hashtbl.replace left (a, b) last) e;
      let chain (a, b) =
        match find_segment s (a, b) with
        | None -> []
        | Some g -> let l = s.chains.(g) in (if a < b then l else List.rev l) @ [ b ] in
      Array.iteri (fun i (a, b) ->
          (* from a through some carried points, forward, to b *)
          let rec go a = function
            | _ when a = b -> ()
            | [] -> note w (f.b_line + i) "facet-%d-edge-%d-%d" n (fst f.boundary.(i)) (snd f.boundary.(i))
            | m :: ms -> if Hashtbl.mem left (a, m) then (Hashtbl.remove left (a, m); go m ms) else go a ms in
          go a (chain (a, b))) f.boundary;
      Hashtbl.iter (fun (a, b) i -> note w (c.t_line + i) "cell-%d-edge-%d-%d-open" i a b) left;
      Array.iteri (fun i (a, b) ->
          ignore (List.fold_left (fun x y ->
              if not (Hashtbl.mem e (x, y) || Hashtbl.mem e (y, x)) then note w (f.c_line + i) "facet-%d-constraint-%d-%d-edge-%d-%d" n a b x y;
              y) a (chain (a, b)))) f.inner;
      Array.iteri (fun i v -> if not (Hashtbl.mem corners.(n) v) then note w (f.p_line + i) "facet-%d-vertex-%d-in-no-cell" n v) f.isolated) c.plc.facets;
  settle "tiling" w

let diagnose s (c : Reader.certificate) (d : certificate) =
  match load_segments s.table s.complex.c_segments d.d_segments XH PositiveMap.empty with
  | None -> reject "carrier" c.q_line "points-of-a-segment"
  | Some sm ->
      let t = load_pairs s.complex.c_segments XH PositiveMap.empty in
      let contexts = Array.mapi (fun n f -> context_of s.table sm t (s.key n) (facet s.key f)) c.plc.facets in
      Array.iteri (fun i (tc : Reader.cell) ->
          match contexts.(tc.facet) with
          | None -> reject "complex" c.plc.facets.(tc.facet).f_line "facet-%d" tc.facet
          | Some x -> if not (cell_shape s.table x (cell_of s tc Witness.nowhere)) then begin
              List.iter (fun v -> if not (corner_in s.table x (s.key v)) then reject "cell" (c.t_line + i) "cell-%d-point-%d" i v) [ tc.a; tc.b; tc.c ];
              let l = Option.get (locate s.table (cell_of s tc Witness.nowhere)) in
              let clockwise = let u = vsub l.l_b l.l_a and v = vsub l.l_c l.l_a in Z.sign (smallest l.l_w l.l_a u v (vcross u v)).s_d > 0 in
              reject "cell" (c.t_line + i) "cell-%d-%s" i (if clockwise then "clockwise" else "collinear")
            end) c.cells;
      Extras.box s.given c;
      tiling s c;
      let tied = ref None in
      Array.iteri (fun i (tc : Reader.cell) ->
          let x = Option.get contexts.(tc.facet) in
          let bare = cell_of s tc Witness.nowhere in
          let l = Option.get (locate s.table bare) in
          let sphere = cell_sphere x.x_plane bare l in
          let judged = judge s.table sm t x bare l sphere in
          let worst = ref None in
          let box = Witness.sphere_box s.g sphere in
          let f k =
            (match judged k with
            | Fine -> ()
            | Inside -> worst := (match !worst with Some (Inside, _) as o -> o | _ -> Some (Inside, k))
            | Tied -> if !worst = None then worst := Some (Tied, k));
            true in
          ignore (query f box d.d_tree);
          let index k = let rec go = function XH -> 1 | XO p -> 2 * go p | XI p -> (2 * go p) + 1 in go k - 1 in
          match !worst with
          | Some (Inside, k) -> reject "emptiness" (c.t_line + i) "cell-%d-point-%d" i (index k)
          | Some (Tied, k) -> if !tied = None then tied := Some (c.t_line + i, i, index k)
          | _ -> ()) c.cells;
      (match !tied with Some (line, i, k) -> reject "tie" line "cell-%d-point-%d" i k | None -> ());
      hanging_records s c;
      let line = ref c.h_line in
      let used = hanging_segments c s in
      Array.iteri (fun g (a, b) ->
          if not used.(g) then begin
            let ends = s.chains.(g) @ [ b ] in
            let _, boxes = List.nth d.d_segments g in
            ignore (List.fold_left2 (fun a b q ->
                if not (subsegment_ok s.table d.d_tree s.g (s.key a) (s.key b) q) then begin
                  let ((w, u), v), _ = common s.points.(a) s.points.(b) s.points.(a) in
                  let sphere = diametral w u (vsub v u) in
                  Array.iteri (fun i p -> if i <> a && i <> b && Z.sign (power sphere p) <= 0 then reject "hanging" !line "subsegment-%d-point-%d" (!line - c.h_line) i) s.points;
                  reject "hanging" !line "subsegment-%d" (!line - c.h_line)
                end;
                incr line;
                b) a ends boxes)
          end) c.plc.segments;
      failwith "the check said no, and no rule is violated"
