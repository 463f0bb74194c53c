(* SPDX-License-Identifier: Apache-2.0 *)
(* Witnesses for the extracted check: points over a common denominator, chains, a tree of boxes, a box for each sphere.
   Nothing here is trusted: a wrong witness makes the check fail. *)
module Integer = Z
open Check
module Z = Integer

let zmul = Z.mul and zadd = Z.add and zsub = Z.sub

(* Keys: binary numbers share their tails, so a million keys are a million small blocks. *)
let keys n =
  let k = Array.make (n + 2) XH in
  for i = 2 to n + 1 do
    k.(i) <- (if i land 1 = 0 then XO k.(i / 2) else XI k.(i / 2))
  done;
  fun i -> k.(i + 1)

let hpoint (hx, hy, hz, hw) = { hx; hy; hz; hw }

(* The least common denominator, unless it is too large to be of use. *)
let common_denominator points =
  let rec go i d =
    if Z.numbits d > 1024 then None
    else if i = Array.length points then Some d
    else
      let w = points.(i).hw in
      go (i + 1) (if Z.divisible d w then d else Z.lcm d w) in
  go 0 Z.one

let over_common d p =
  if Z.equal p.hw d then p
  else
    let k = Z.divexact d p.hw in
    { hx = zmul k p.hx; hy = zmul k p.hy; hz = zmul k p.hz; hw = d }

let float_of n w = Q.to_float { Q.num = n; Q.den = w }

(* The boxes' denominator: the common one, or a power of two that leaves about 45 bits for the largest coordinate. *)
let scale points =
  match common_denominator points with
  | Some d -> (d, Array.map (over_common d) points)
  | None ->
      let bits = ref (-1000) in
      Array.iter (fun p -> List.iter (fun c -> bits := max !bits (Z.numbits c - Z.numbits p.hw)) [ p.hx; p.hy; p.hz ]) points;
      (Z.shift_left Z.one (max 0 (45 - !bits)), points)

let floor_at g n w = if Z.equal g w then n else Z.fdiv (zmul g n) w
let ceil_at g n w = if Z.equal g w then n else Z.cdiv (zmul g n) w

(* ---- the tree ---- *)

let select idx key lo hi k =
  (* afterwards idx.(k) is in its place within lo .. hi-1 *)
  let lo = ref lo and hi = ref (hi - 1) in
  while !lo < !hi do
    let p : float = key.(idx.((!lo + !hi) / 2)) in
    let i = ref !lo and j = ref !hi in
    while !i <= !j do
      while key.(idx.(!i)) < p do incr i done;
      while key.(idx.(!j)) > p do decr j done;
      if !i <= !j then begin
        let t = idx.(!i) in
        idx.(!i) <- idx.(!j);
        idx.(!j) <- t;
        incr i; decr j
      end
    done;
    if k <= !j then hi := !j else if k >= !i then lo := !i else (lo := k; hi := k)
  done

let union b c =
  { lox = Z.min b.lox c.lox; hix = Z.max b.hix c.hix; loy = Z.min b.loy c.loy; hiy = Z.max b.hiy c.hiy; loz = Z.min b.loz c.loz; hiz = Z.max b.hiz c.hiz }

let leaf_size = 1

let tree g key points =
  let n = Array.length points in
  let finite x = if Float.is_nan x then 0. else x in
  let coordinates = [| Array.map (fun p -> finite (float_of p.hx p.hw)) points; Array.map (fun p -> finite (float_of p.hy p.hw)) points;
                       Array.map (fun p -> finite (float_of p.hz p.hw)) points |] in
  let idx = Array.init n Fun.id in
  let point_box i =
    let p = points.(i) in
    let lo c = floor_at g c p.hw and hi c = ceil_at g c p.hw in
    { lox = lo p.hx; hix = hi p.hx; loy = lo p.hy; hiy = hi p.hy; loz = lo p.hz; hiz = hi p.hz } in
  let box_of = function Leaf0 (b, _) | Node0 (b, _, _) -> b in
  let rec build lo hi =
    if hi - lo <= leaf_size then begin
      let b = ref (point_box idx.(lo)) in
      for i = lo + 1 to hi - 1 do b := union !b (point_box idx.(i)) done;
      Leaf0 (!b, List.init (hi - lo) (fun i -> key idx.(lo + i)))
    end
    else begin
      let extent c =
        let a = ref infinity and b = ref neg_infinity in
        for i = lo to hi - 1 do
          let x = c.(idx.(i)) in
          if x < !a then a := x;
          if x > !b then b := x
        done;
        !b -. !a in
      let e = Array.map extent coordinates in
      let d = if e.(0) >= e.(1) && e.(0) >= e.(2) then 0 else if e.(1) >= e.(2) then 1 else 2 in
      let mid = (lo + hi) / 2 in
      select idx coordinates.(d) lo hi mid;
      let l = build lo mid in
      let r = build mid hi in
      Node0 (union (box_of l) (box_of r), l, r)
    end in
  if n = 0 then Leaf0 ({ lox = Z.zero; hix = Z.zero; loy = Z.zero; hiy = Z.zero; loz = Z.zero; hiz = Z.zero }, []) else build 0 n

(* ---- boxes of spheres ---- *)

let nowhere = { lox = Z.zero; hix = Z.zero; loy = Z.zero; hiy = Z.zero; loz = Z.zero; hiz = Z.zero }

let sphere_box g (s : sphere) =
  if Z.sign s.s_d <= 0 then nowhere
  else begin
    let m = s.s_m and a = s.s_a in
    let r = Z.succ (Z.sqrt (zadd (zmul m.vx m.vx) (zadd (zmul m.vy m.vy) (zmul m.vz m.vz)))) in
    if Z.equal s.s_w g then begin
      let lo a m = zadd a (Z.fdiv (zsub m r) s.s_d) and hi a m = zadd a (Z.cdiv (zadd m r) s.s_d) in
      { lox = lo a.vx m.vx; hix = hi a.vx m.vx; loy = lo a.vy m.vy; hiy = hi a.vy m.vy; loz = lo a.vz m.vz; hiz = hi a.vz m.vz }
    end
    else begin
      let d = zmul s.s_d s.s_w in
      let lo a m = Z.fdiv (zmul g (zsub (zadd (zmul a s.s_d) m) r)) d and hi a m = Z.cdiv (zmul g (zadd (zadd (zmul a s.s_d) m) r)) d in
      { lox = lo a.vx m.vx; hix = hi a.vx m.vx; loy = lo a.vy m.vy; hiy = hi a.vy m.vy; loz = lo a.vz m.vz; hiz = hi a.vz m.vz }
    end
  end

let subsegment_box g p q =
  let ((w, u), v), _ = common p q p in
  sphere_box g (diametral w u (vsub v u))

(* ---- chains: the points carried by a segment, by their distance from its first vertex ---- *)

let chain points a carried =
  match carried with
  | [] | [ _ ] -> carried
  | _ ->
      (* an affine function along the segment: the coordinate in which it is longest would do; the dot product always does *)
      let p = points.(a) in
      let diff q =
        (zsub (zmul q.hx p.hw) (zmul p.hx q.hw), zsub (zmul q.hy p.hw) (zmul p.hy q.hw), zsub (zmul q.hz p.hw) (zmul p.hz q.hw), zmul q.hw p.hw) in
      let dx, dy, dz, _ = diff points.(List.hd carried) in
      let along i =
        let x, y, z, w = diff points.(i) in
        (zadd (zmul x dx) (zadd (zmul y dy) (zmul z dz)), w, i) in
      let l = List.rev_map along carried in
      let l = List.sort (fun (s, w, _) (t, v, _) -> Z.compare (zmul s v) (zmul t w)) l in
      List.rev (List.rev_map (fun (_, _, i) -> i) l)
