(* SPDX-License-Identifier: Apache-2.0 *)
(* The rules box and rows, in plain OCaml: they say nothing about conformity, and nothing here is proved. *)
open Check

exception Rejected of string * int * string

let reject rule line fmt = Printf.ksprintf (fun what -> raise (Rejected (rule, line, what))) fmt
let holds rule n what = Printf.printf "rule %-9s holds: %d %s\n%!" rule n what

let place p = [| Q.make p.hx p.hw; Q.make p.hy p.hw; Q.make p.hz p.hw |]
let minus = Array.map2 Q.sub
let dot a b = Q.add (Q.mul a.(0) b.(0)) (Q.add (Q.mul a.(1) b.(1)) (Q.mul a.(2) b.(2)))
let equal a b = Array.for_all2 Q.equal a b

let cross a b =
  let m i j = Q.sub (Q.mul a.(i) b.(j)) (Q.mul a.(j) b.(i)) in
  [| m 1 2; m 2 0; m 0 1 |]

(* Two boxes' halves stand on consecutive lines: the reader has seen to it. *)
let box given (c : Reader.certificate) =
  let at i = place given.(i) in
  let edges (t : Reader.cell) = [ (t.a, t.b, t.c); (t.b, t.c, t.a); (t.c, t.a, t.b) ] in
  let n = ref 0 in
  Array.iteri (fun i (t : Reader.cell) ->
      if t.box >= 0 && i > 0 && c.cells.(i - 1).box = t.box then begin
        incr n;
        let first = c.cells.(i - 1) in
        let line = c.t_line + i - 1 in
        if first.facet <> t.facet then reject "box" line "box-%d-two-facets" t.box;
        let shared = List.concat_map (fun (u, v, w) -> List.filter_map (fun (x, y, z) -> if x = v && y = u then Some (u, v, w, z) else None) (edges t)) (edges first) in
        match shared with
        | [ (u, v, w1, w2) ] ->
            let u = at u and v = at v and w1 = at w1 and w2 = at w2 in
            if not (equal (minus u w1) (minus w2 v)) then reject "box" line "box-%d-no-parallelogram" t.box;
            if Q.sign (dot (minus w2 u) (minus w1 u)) <> 0 then reject "box" line "box-%d-no-right-angle" t.box
        | _ -> reject "box" line "box-%d-no-common-edge" t.box
      end) c.cells;
  holds "box" !n "boxes"

let rows given chains (c : Reader.certificate) =
  let vertices = Array.length c.plc.vertices in
  let at i = place given.(i) in
  let own = Hashtbl.create 64 in
  Array.iteri (fun n (r : Reader.row) ->
      let m = Array.length r.members in
      let a, b = c.plc.segments.(r.segment) in
      let count = List.length chains.(r.segment) in
      match r.side with
      | None ->
          if m <> count then reject "rows" r.r_line "row-%d-count" n;
          List.iteri (fun i x -> if r.members.(i) <> x then reject "rows" (r.r_line + 1 + i) "row-%d-point-%d" n r.members.(i)) chains.(r.segment);
          Hashtbl.replace own r.segment ()
      | Some (f, left) ->
          if not (Hashtbl.mem own r.segment) then reject "rows" r.r_line "row-%d-without-segment-row" n;
          if m <> count then reject "rows" r.r_line "row-%d-count" n;
          let facet = c.plc.facets.(f) in
          let bounds e = Array.mem e facet.boundary in
          if bounds (a, b) || bounds (b, a) then (if left <> bounds (a, b) then reject "rows" r.r_line "row-%d-side" n)
          else if not (Array.mem (a, b) facet.inner) then reject "rows" r.r_line "row-%d-segment-%d-not-in-facet" n r.segment;
          let i, j, k = facet.corners in
          let normal = cross (minus (at j) (at i)) (minus (at k) (at i)) and along = minus (at b) (at a) in
          let first = ref None in
          List.iteri (fun i x ->
              let q = r.members.(i) in
              let line = r.r_line + 1 + i in
              if q < vertices || not c.is_offset.(q - vertices) then reject "rows" line "row-%d-point-%d-kind" n q;
              (match c.steiner.(q - vertices) with _, Reader.Facet g when g = f -> () | _ -> reject "rows" line "row-%d-point-%d-carrier" n q);
              let o = minus (at q) (at x) in
              (match !first with
              | None -> first := Some o
              | Some o' -> if not (equal o o') then reject "rows" line "row-%d-point-%d-vector" n q);
              if Q.sign (dot o along) <> 0 then reject "rows" line "row-%d-point-%d-not-orthogonal" n q;
              let s = Q.sign (dot normal (cross along o)) in
              if (if left then s <= 0 else s >= 0) then reject "rows" line "row-%d-point-%d-side" n q) chains.(r.segment)) c.rows;
  holds "rows" (Array.length c.rows) "rows"
