(* SPDX-License-Identifier: Apache-2.0 *)
(* The integers of the extracted check: zarith's. *)
include Z

let two = Z.of_int 2

(* For functions of Coq's library that extraction writes out and nothing calls. *)
let unused _ = failwith "unused"
