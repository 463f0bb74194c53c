(* SPDX-License-Identifier: Apache-2.0 *)
(* The strict reader of docs/certificate-format.md, sections 1 to 3. Part of the trusted base. *)

exception Malformed of { line : int; column : int; code : string; message : string }
exception Declined of string

type point = Z.t * Z.t * Z.t * Z.t (* X Y Z W; in dimension 2 Z = 0 *)
type carrier = Segment of int | Facet of int

type facet = {
  f_line : int;
  corners : int * int * int;
  b_line : int; (* of the first b record; c and p likewise *)
  boundary : (int * int) array;
  c_line : int;
  inner : (int * int) array;
  p_line : int;
  isolated : int array;
}

type plc = {
  dimension : int;
  v_line : int;
  vertices : point array;
  s_line : int;
  segments : (int * int) array;
  facets : facet array;
  sha256 : string;
  first : int; (* the bytes of the block *)
  last : int;
}

type cell = { facet : int; a : int; b : int; c : int; box : int; (* -1: none *) offset : (Z.t * Z.t) option }
type row = { r_line : int; segment : int; side : (int * bool) option; (* facet, left *) members : int array }

type certificate = {
  plc : plc;
  q_line : int;
  steiner : (point * carrier) array;
  is_offset : bool array; (* Steiner points of kind offset *)
  t_line : int;
  cells : cell array;
  rows : row array;
  h_line : int;
  hanging : (int * int * int) array;
  end_line : int;
  digest : string; (* as stated *)
  digest_found : string;
}

(* A cursor: [pos] within the line that ends (with its LF) at [eol]. *)
type t = { text : string; mutable pos : int; mutable start : int; mutable eol : int; mutable line : int }

let fail r code message = raise (Malformed { line = r.line; column = r.pos - r.start + 1; code; message })
let syntax r message = fail r "E-SYNTAX" message

let max_line = 1_048_576
let max_index = 0x7fff_ffff
let max_digits = 65_536

(* Of a line that is too long, or that the text ends in: what is wrong within it comes first. *)
let legible r stop =
  for i = r.start to stop - 1 do
    match r.text.[i] with ' ' .. '~' -> () | _ -> r.pos <- i; syntax r "a byte that is not printable ASCII"
  done

let next r =
  let from = r.eol + 1 in
  r.line <- r.line + 1;
  r.start <- from;
  r.pos <- from;
  let found = String.index_from_opt r.text from '\n' in
  let stop = Option.value found ~default:(String.length r.text) in
  if stop - from > max_line then (legible r (from + max_line); raise (Declined "too-large"));
  if found = None then (legible r stop; fail r "E-TRUNCATED" "the text ends early");
  r.eol <- stop

let peek r = r.text.[r.pos] (* at the latest the LF *)
let space r = if peek r = ' ' then r.pos <- r.pos + 1 else syntax r "one space expected"
let finish r = if r.pos <> r.eol then syntax r "the line should end here"

let starts r word =
  let n = String.length word in
  r.eol - r.pos >= n
  && String.sub r.text r.pos n = word
  && (r.pos + n = r.eol || r.text.[r.pos + n] = ' ')

let word r w = if starts r w then r.pos <- r.pos + String.length w else syntax r (Printf.sprintf "`%s' expected" w)
let is_digit c = c >= '0' && c <= '9'

let number r =
  let from = r.pos in
  while is_digit (peek r) do r.pos <- r.pos + 1 done;
  let n = r.pos - from in
  let what = if peek r <> ' ' && peek r <> '\n' then syntax r "a decimal index or count expected" else n in
  if what = 0 then syntax r "a decimal index or count expected";
  if n > 1 && r.text.[from] = '0' then (r.pos <- from; syntax r "a leading zero");
  if n > 10 then raise (Declined "too-large");
  let x = int_of_string (String.sub r.text from n) in
  if x > max_index then raise (Declined "too-large");
  x

let below r limit what =
  let at = r.pos in
  let x = number r in
  if x >= limit then (r.pos <- at; fail r "E-RANGE" (Printf.sprintf "%s %d does not exist" what x));
  x

let is_hex c = is_digit c || (c >= 'a' && c <= 'f')

let integer_until r stop =
  let from = r.pos in
  let negative = peek r = '-' in
  if negative then r.pos <- r.pos + 1;
  let first = r.pos in
  while is_hex (peek r) do r.pos <- r.pos + 1 done;
  let n = r.pos - first in
  if n = 0 || not (stop (peek r)) then syntax r "a hexadecimal integer expected";
  if r.text.[first] = '0' && (n > 1 || negative) then (r.pos <- from; syntax r "not the canonical spelling");
  if n > max_digits then raise (Declined "too-large");
  let z = Z.of_substring_base 16 r.text ~pos:first ~len:n in
  if negative then Z.neg z else z

let ends c = c = ' ' || c = '\n'
let integer r = integer_until r ends

let read_point r dimension =
  let at = r.pos in
  let x = integer r in
  space r;
  let y = integer r in
  space r;
  let z = if dimension = 3 then (let z = integer r in space r; z) else Z.zero in
  let w = integer r in
  finish r;
  let stop = r.pos in
  r.pos <- at;
  if Z.sign w <= 0 then fail r "E-VALUE" "W is not positive";
  if not (Z.equal (Z.gcd (Z.gcd x y) (Z.gcd z w)) Z.one) then fail r "E-VALUE" "the coordinates have a common divisor";
  r.pos <- stop;
  (x, y, z, w)

(* Growing arrays: announced counts reserve nothing. *)
let collect n read =
  let rec go i acc = if i = n then Array.of_list (List.rev acc) else go (i + 1) (read i :: acc) in
  go 0 []

(* A header [w COUNT]; [before] says what a further record of the list above would look like. *)
let header ?(before = fun _ -> false) r w =
  next r;
  if (not (starts r w)) && before r then fail r "E-COUNT" "more records than announced";
  word r w;
  space r;
  let n = number r in
  finish r;
  n

let bare r = is_digit (peek r)

(* [n] records, each a line; [after] recognises the line that follows the list. *)
let records r n ~is ~after read =
  collect n (fun i ->
      next r;
      if (not (is r)) && after r then fail r "E-COUNT" "fewer records than announced";
      let x = read i in
      finish r;
      x)

let tagged w r = starts r w

let ordered r compare previous x =
  match !previous with
  | Some y when compare y x >= 0 -> r.pos <- r.start; fail r "E-ORDER" "not strictly increasing"
  | _ -> previous := Some x

let read_plc r =
  next r;
  let first = r.start in
  word r "plc"; space r;
  if not (starts r "1") then syntax r "`plc 1' expected";
  word r "1"; finish r;
  next r;
  word r "dim"; space r;
  let at = r.pos in
  let dimension = number r in
  if dimension <> 2 && dimension <> 3 then (r.pos <- at; fail r "E-VALUE" "the dimension is 2 or 3");
  finish r;
  let n = header r "vertices" in
  let v_line = r.line + 1 in
  let vertices = records r n ~is:(tagged "v") ~after:(tagged "segments") (fun _ -> word r "v"; space r; read_point r dimension) in
  let s = header r "segments" ~before:(tagged "v") in
  let s_line = r.line + 1 in
  let last = ref None in
  let segments = records r s ~is:(tagged "s") ~after:(tagged "facets") (fun _ ->
      word r "s"; space r;
      let a = below r n "vertex" in
      space r;
      let b = below r n "vertex" in
      if a >= b then (r.pos <- r.start; fail r "E-ORDER" "the first vertex of a segment is the smaller one");
      ordered r compare last (a, b);
      (a, b)) in
  let f = header r "facets" ~before:(tagged "s") in
  if dimension = 2 && f > 1 then (r.pos <- r.start; fail r "E-VALUE" "in dimension 2 there is at most one facet");
  let pair () =
    let a = below r n "vertex" in
    space r;
    let b = below r n "vertex" in
    (a, b) in
  let facets = collect f (fun _ ->
      next r;
      if (not (starts r "f")) && starts r "end" then fail r "E-COUNT" "fewer facets than announced";
      if bare r then fail r "E-COUNT" "more isolated vertices than announced";
      word r "f";
      let f_line = r.line in
      space r;
      let i = below r n "vertex" in
      space r;
      let j = below r n "vertex" in
      space r;
      let k = below r n "vertex" in
      finish r;
      let b = header r "b" in
      if b < 3 then (r.pos <- r.start; fail r "E-VALUE" "fewer than three boundary edges");
      let b_line = r.line + 1 in
      let last = ref None in
      let boundary = records r b ~is:bare ~after:(tagged "c") (fun _ -> let e = pair () in ordered r compare last e; e) in
      let c = header r "c" ~before:bare in
      let c_line = r.line + 1 in
      let last = ref None in
      let inner = records r c ~is:bare ~after:(tagged "p") (fun _ ->
          let a, b = pair () in
          if a >= b then (r.pos <- r.start; fail r "E-ORDER" "the first vertex of a constraint is the smaller one");
          ordered r compare last (a, b);
          (a, b)) in
      let p = header r "p" ~before:bare in
      let p_line = r.line + 1 in
      let last = ref None in
      let after r = starts r "end" || starts r "f" in
      let isolated = records r p ~is:bare ~after (fun _ -> let a = below r n "vertex" in ordered r compare last a; a) in
      { f_line; corners = (i, j, k); b_line; boundary; c_line; inner; p_line; isolated }) in
  next r;
  if (not (starts r "end")) && (starts r "f" || (f > 0 && bare r)|| (f = 0 && starts r "s")) then fail r "E-COUNT" "more records than announced";
  word r "end"; finish r;
  let last = r.eol + 1 in
  { dimension; v_line; vertices; s_line; segments; facets; sha256 = Sha256.hex r.text first last; first; last }

let cursor text = { text; pos = 0; start = 0; eol = -1; line = 0 }
let nothing_after r = if r.eol + 1 <> String.length r.text then (r.line <- r.line + 1; r.start <- r.eol + 1; r.pos <- r.start; fail r "E-TRAILING" "text after the end")

let read_note r =
  word r "n"; space r;
  let from = r.pos in
  while (match peek r with 'a' .. 'z' | '-' -> true | _ -> false) do r.pos <- r.pos + 1 done;
  if r.pos = from then syntax r "a key expected";
  space r;
  if r.pos = r.eol then syntax r "a text expected";
  while r.pos < r.eol do
    (match peek r with
    | '!' .. '~' -> ()
    | ' ' -> if r.text.[r.pos - 1] = ' ' || r.pos + 1 = r.eol then syntax r "a single space within the text only"
    | _ -> syntax r "printable characters and single spaces only");
    r.pos <- r.pos + 1
  done

(* This checker knows the claim `conforms' only; certificates with claims of docs/lemma-claims.md are declined. *)
let lemmas =
  [ "H-angle"; "H-ball"; "H-offset"; "H-chord"; "L1"; "L2"; "L3"; "L4"; "L5"; "L6"; "L7"; "L8"; "L9"; "L10"; "L11"; "L12"; "L13"; "L14"; "L15"; "L16"; "L17"; "L18";
    "L18b"; "L19"; "L20"; "L21"; "L22"; "L23" ]
let refutable = [ "L5"; "L9"; "L10"; "L11"; "L13"; "L18" ]

let read_claims r =
  let claim count =
    next r;
    if starts r "notes" then fail r "E-COUNT" "fewer claims than announced";
    let refutes = starts r "refutes" in
    word r (if refutes then "refutes" else "claim"); space r;
    if (not refutes) && starts r "conforms" then begin
      word r "conforms"; finish r;
      if count > 0 then (r.pos <- r.start; fail r "E-ORDER" "a claim twice")
    end
    else match List.find_opt (starts r) (if refutes then refutable else lemmas) with
      | None -> syntax r "an unknown claim"
      | Some id -> word r id; if not refutes then (space r; ignore (number r)); finish r; raise (Declined "claims") in
  next r; word r "claims"; space r;
  let at = r.pos in
  let count = number r in
  finish r;
  if count = 0 then (r.pos <- at; fail r "E-VALUE" "a certificate without a claim");
  for i = 0 to count - 1 do claim i done

let certificate text =
  let r = cursor text in
  next r;
  word r "confidel-certificate"; space r;
  if starts r "1" then (word r "1"; finish r)
  else begin
    let from = r.pos in
    while is_digit (peek r) do r.pos <- r.pos + 1 done;
    if r.pos = from || r.pos <> r.eol || r.text.[from] = '0' then (r.pos <- from; syntax r "a version expected");
    raise (Declined "newer-version")
  end;
  let plc = read_plc r in
  let n = Array.length plc.vertices and s = Array.length plc.segments and f = Array.length plc.facets in
  read_claims r;
  let notes = header r "notes" ~before:(fun r -> starts r "claim" || starts r "refutes") in
  ignore (records r notes ~is:(tagged "n") ~after:(tagged "parameters") (fun _ -> read_note r));
  next r;
  if starts r "n" then fail r "E-COUNT" "more notes than announced";
  word r "parameters"; space r; word r "0"; finish r;
  let q = header r "points" in
  if n + q > max_index + 1 then raise (Declined "too-large");
  let q_line = r.line + 1 in
  let steiner = records r q ~is:(tagged "q") ~after:(tagged "cells") (fun _ ->
      word r "q"; space r;
      let kind =
        if starts r "projection" then "projection" else if starts r "edge" then "edge" else if starts r "offset" then "offset"
        else if starts r "arc" then "arc" else if starts r "interior" then "interior" else syntax r "an unknown kind of point" in
      word r kind; space r;
      let carrier = match kind with
        | "projection" | "edge" -> Segment (below r s "segment")
        | _ -> Facet (below r f "facet") in
      space r;
      ((read_point r plc.dimension, carrier), kind = "offset")) in
  let is_offset = Array.map snd steiner and steiner = Array.map fst steiner in
  let points = n + q in
  let t = header r "cells" ~before:(tagged "q") in
  let t_line = r.line + 1 in
  let boxes = ref 0 and half = ref false in
  let check_box what = if !half <> what then (r.pos <- r.start; fail r "E-ORDER" "a box number stands on exactly two consecutive lines") in
  let cells = records r t ~is:(tagged "t") ~after:(tagged "rows") (fun _ ->
      word r "t"; space r;
      let facet = below r f "facet" in
      space r;
      let a = below r points "point" in
      space r;
      let b = below r points "point" in
      space r;
      let c = below r points "point" in
      space r;
      let kind = peek r in
      (match kind with 'T' | 'S' | 'R' | 'C' -> r.pos <- r.pos + 1 | _ -> syntax r "an unknown kind of cell");
      if not (ends (peek r)) then syntax r "an unknown kind of cell";
      let box = if kind <> 'R' then -1 else !boxes - if !half then 1 else 0 in
      if kind = 'R' then begin
        space r;
        let x = number r in
        if !half then (if x <> !boxes - 1 then check_box false; half := false)
        else begin
          if x <> !boxes then (r.pos <- r.start; fail r "E-ORDER" "boxes are numbered in order");
          incr boxes; half := true
        end
      end
      else check_box false;
      let offset =
        if r.pos = r.eol then None
        else begin
          space r;
          let at = r.pos in
          let num = integer_until r (fun c -> c = '/') in
          r.pos <- r.pos + 1;
          let den = integer r in
          let stop = r.pos in
          r.pos <- at;
          if plc.dimension = 2 then fail r "E-VALUE" "an offset in dimension 2";
          if Z.sign den <= 0 then fail r "E-VALUE" "the denominator is not positive";
          if Z.sign num = 0 then fail r "E-VALUE" "an offset of zero";
          if not (Z.equal (Z.gcd num den) Z.one) then fail r "E-VALUE" "not in lowest terms";
          r.pos <- stop;
          Some (num, den)
        end in
      { facet; a; b; c; box; offset }) in
  let rows =
    next r;
    if starts r "t" then fail r "E-COUNT" "more cells than announced";
    check_box false;
    word r "rows"; space r;
    let x = number r in
    finish r;
    x in
  let last = ref None in
  let blocks = collect rows (fun _ ->
    next r;
    if (not (starts r "r")) && (starts r "hanging" || bare r) then fail r "E-COUNT" "another number of records than announced";
    word r "r"; space r;
    let segment = below r s "segment" in
    space r;
    let at = r.pos in
    let m = number r in
    if m < 2 then (r.pos <- at; fail r "E-VALUE" "a row has at least two points");
    let r_line = r.line in
    let (_, facet, side) as key =
      if r.pos = r.eol then (segment, -1, 0)
      else begin
        space r;
        let facet = below r f "facet" in
        space r;
        let side = if starts r "+" then 0 else if starts r "-" then 1 else syntax r "`+' or `-' expected" in
        r.pos <- r.pos + 1;
        (segment, facet, side)
      end in
    finish r;
    ordered r compare last key;
    let after r = starts r "r" || starts r "hanging" in
    let members = records r m ~is:bare ~after (fun _ -> below r points "point") in
    { r_line; segment; side = (if facet < 0 then None else Some (facet, side = 0)); members }) in
  next r;
  if starts r "r" || bare r then fail r "E-COUNT" "more rows than announced";
  word r "hanging"; space r;
  let h = number r in
  finish r;
  let h_line = r.line + 1 in
  let last = ref 0 in
  let hanging = records r h ~is:(tagged "h") ~after:(tagged "evidence") (fun _ ->
      word r "h"; space r;
      let segment = below r s "segment" in
      if segment < !last then (r.pos <- r.start; fail r "E-ORDER" "segments increase");
      last := segment;
      space r;
      let a = below r points "point" in
      space r;
      let b = below r points "point" in
      (segment, a, b)) in
  next r;
  if starts r "h" then fail r "E-COUNT" "more subsegments than announced";
  word r "evidence"; space r; word r "0"; finish r;
  next r;
  let end_line = r.line and stop = r.start in
  word r "end";
  List.iter (fun count ->
      space r;
      let at = r.pos in
      if number r <> count then (r.pos <- at; fail r "E-COUNT" "counts differ"))
    [ n; s; f; q; t; rows; h ];
  space r;
  if r.eol - r.pos <> 64 then syntax r "64 digits expected";
  for i = r.pos to r.eol - 1 do if not (is_hex text.[i]) then (r.pos <- i; syntax r "a lower-case hexadecimal digit expected") done;
  let digest = String.sub text r.pos 64 in
  nothing_after r;
  { plc; q_line; steiner; is_offset; t_line; cells; rows = blocks; h_line; hanging; end_line; digest; digest_found = Sha256.hex text 0 stop }
