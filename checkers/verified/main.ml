(* SPDX-License-Identifier: Apache-2.0 *)
(* confidel-check-verified CERTIFICATE [--complex COMPLEX]

   Reads, computes witnesses, and asks the extracted function Check.check, which is proved sound (proofs/coq/checker, Sound.check_sound).
   "s VERIFIED" is printed only if that function returned true for the complex and the certificate that were read, and the rules
   that are tested in rules.ml (hash, distinct, and those parts of complex, carrier and hanging that the theorem does not need) hold too. *)
module Integer = Z
open Check
module Z = Integer

let version = "confidel-check-verified 1"
let exit_with code = flush stdout; flush stderr; exit code
let undecided why = Printf.printf "s UNDECIDED %s\n" why; exit_with 3

let malformed file line column code message =
  if line = 0 then Printf.eprintf "%s: error[%s]: %s\n" file code message
  else Printf.eprintf "%s:%d:%d: error[%s]: %s\n" file line column code message;
  exit_with 2

let usage message =
  Printf.eprintf "error[E-USAGE]: %s\nusage: confidel-check-verified CERTIFICATE [--complex COMPLEX]\n" message;
  exit_with 2

(* ---- files ---- *)

exception Damaged of string

let slurp ic =
  let b = Buffer.create 65536 and chunk = Bytes.create 65536 in
  let since = ref 0 in
  let rec go () =
    let n = input ic chunk 0 65536 in
    if n > 0 then begin
      (match Bytes.rindex_opt (Bytes.sub chunk 0 n) '\n' with
      | None -> since := !since + n
      | Some i -> since := n - i);
      if !since > 2 * Reader.max_line then raise (Reader.Declined "too-large");
      Buffer.add_subbytes b chunk 0 n;
      go ()
    end in
  go ();
  Buffer.contents b

let read_file file =
  let magic =
    let ic = open_in_bin file in
    let m = try really_input_string ic 4 with End_of_file -> "" in
    close_in ic; m in
  if magic = "\x28\xb5\x2f\xfd" then begin
    let channels = Unix.open_process_args_full "zstd" [| "zstd"; "-dcq"; "--"; file |] (Unix.environment ()) in
    let ic, _, ec = channels in
    let text = try slurp ic with e -> (ignore (Unix.close_process_full channels); raise e) in
    let said = try input_line ec with End_of_file -> "" in
    match Unix.close_process_full channels with
    | Unix.WEXITED 0 -> text
    | _ ->
        let has w = let n = String.length w in let rec at i = i + n <= String.length said && (String.sub said i n = w || at (i + 1)) in at 0 in
        if has "too much memory" then raise (Reader.Declined "too-large") else raise (Damaged "zstd cannot read this")
  end
  else begin
    let ic = open_in_bin file in
    let text = slurp ic in
    close_in ic; text
  end

let guarded file f =
  try f (read_file file) with
  | Reader.Malformed { line; column; code; message } -> malformed file line column code message
  | Damaged message -> malformed file 0 0 "E-ZSTD" message
  | Reader.Declined why -> undecided why
  | Sys_error message -> Printf.eprintf "%s\n" message; exit_with 4

let memory () =
  try
    let ic = open_in "/proc/self/status" in
    let rec go () =
      let l = input_line ic in
      if String.length l > 6 && String.sub l 0 6 = "VmHWM:" then Scanf.sscanf (String.sub l 6 (String.length l - 6)) " %d" (fun k -> k / 1024) else go () in
    let m = go () in
    close_in ic; m
  with _ -> 0

let run file complex =
  let clock = Sys.time () in
  let text, c = guarded file (fun text -> (text, Reader.certificate text)) in
  let given = Option.map (fun f -> guarded f Fun.id) complex in
  let reading = Sys.time () -. clock in
  let plc = c.plc in
  Printf.printf "complex sha256 %s, %s\n" plc.sha256 (match complex with None -> "not compared" | Some f -> "compared with " ^ f);
  Printf.printf "dimension %d: %d vertices, %d segments, %d facets, %d Steiner points, %d cells, %d rows, %d subsegments\n" plc.dimension
    (Array.length plc.vertices) (Array.length plc.segments) (Array.length plc.facets) (Array.length c.steiner) (Array.length c.cells) (Array.length c.rows) (Array.length c.hanging);
  flush stdout;
  let s = Rules.prepare c in
  Rules.hash c;
  Rules.complex s c text given;
  Rules.distinct s c;
  Rules.carrier s c;
  let t0 = Sys.time () in
  let certificate = Rules.certificate s c in
  let t1 = Sys.time () in
  let accepted = check s.Rules.complex certificate in
  let t2 = Sys.time () in
  if not accepted then (ignore (Rules.diagnose s c certificate); failwith "the check said no");
  Extras.box s.Rules.given c;
  Rules.hanging_records s c;
  Extras.rows s.Rules.given s.Rules.chains c;
  print_endline "proved: the function that accepted this certificate is sound (Sound.check_sound): every Delaunay subdivision of the points conforms to the complex";
  if s.Rules.coplanar then print_endline "all points lie in one plane: the statement is about the planar Delaunay subdivisions (Sound.check_sound_planar)";
  print_endline "tested by plain OCaml, not needed for the proof: hash, distinct, carrier of facets' points, box, order of the hanging records, rows";
  print_endline "not checked: kinds of points (but offset, in rows) and of cells, notes; the smallest relative power is not computed";
  let seconds = t2 -. t1 in
  Printf.printf "reading %.3f s, witnesses %.3f s, proved check %.3f s of processor time (%.0f cells per second, witnesses and check), %d MB\n" reading (t1 -. t0) seconds
    (float (Array.length c.cells) /. (t2 -. t0)) (memory ());
  print_endline "s VERIFIED";
  exit_with 0

let () =
  Gc.set { (Gc.get ()) with minor_heap_size = 4 * 1024 * 1024; space_overhead = 200 };
  Sys.set_signal Sys.sigint (Sys.Signal_handle (fun _ -> exit_with 130));
  let file = ref None and complex = ref None in
  let rec args = function
    | [] -> ()
    | "--version" :: _ -> print_endline version; exit_with 0
    | "--complex" :: f :: rest -> complex := Some f; args rest
    | "--complex" :: [] -> usage "--complex needs a file"
    | f :: rest when String.length f > 0 && f.[0] <> '-' -> if !file <> None then usage "one certificate at a time" else (file := Some f; args rest)
    | f :: _ -> usage ("unknown option " ^ f) in
  args (List.tl (Array.to_list Sys.argv));
  match !file with
  | None -> usage "no certificate"
  | Some f -> (
      try run f !complex with
      | Rules.Rejected (rule, line, what) -> Printf.printf "s REJECTED %s %d %s\n" rule line what; exit_with 5
      | Stdlib.Exit as e -> raise e
      | Out_of_memory -> undecided "memory-limit"
      | e -> Printf.eprintf "internal error: %s\n" (Printexc.to_string e); exit_with 70)
