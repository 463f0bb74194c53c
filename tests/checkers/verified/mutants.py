#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Both checkers on mutants of the accepted certificates: they must end with the same exit code, and name the same rule
(for malformed text: the same error and line). Where a rule is broken in two places they may name different lines: that is counted.

    mutants.py GMP-CHECKER VERIFIED-CHECKER [COUNT [SEED]]

A mutant changes one to three tokens or lines; the counts and the digest at the end are repaired, so that it gets past the reader.
Disagreements are kept in the folder `disagreements` of the working directory and make the run fail. Without the verified checker: exit code 77."""
import collections, glob, hashlib, os, random, re, subprocess, sys, tempfile

here = os.path.dirname(os.path.abspath(__file__))

def parents():
    """the certificates of tests/certificates that mutants are made of, as lists of lines; none with claims that only one checker knows"""
    result = []
    for path in sorted(glob.glob(os.path.join(here, '../../certificates/accept/*.cert')) + glob.glob(os.path.join(here, '../../certificates/reject/tie*.cert'))):
        data = open(path, 'rb').read()
        if data[:4] != b'\x28\xb5\x2f\xfd' and len(data) < 40000 and b'\nclaims 1\n' in data:
            result.append(data.decode().split('\n')[:-1])
    return result

def index(line, rnd):
    """another index in place of one of the line's"""
    words = line.split(' ')
    places = [i for i, w in enumerate(words) if w.isdigit() and i > 0]
    if places:
        i = rnd.choice(places)
        words[i] = str(max(0, int(words[i]) + rnd.choice([-2, -1, 1, 2])))
    return ' '.join(words)

def coordinate(line, rnd):
    words = line.split(' ')
    places = [i for i in range(1, len(words) - 1) if re.fullmatch('-?[0-9a-f]+', words[i])]
    if places:
        i = rnd.choice(places)
        v = int(words[i], 16) + rnd.choice([-3, -1, 1, 2, 5])
        words[i] = ('-%x' % -v) if v < 0 else '%x' % v
    return ' '.join(words)

def rotate(line, rnd):
    words = line.split(' ')
    if len(words) > 4:
        i, j = rnd.sample([2, 3, 4], 2)
        words[i], words[j] = words[j], words[i]
    return ' '.join(words)

def offset(line, rnd):
    words = [w for w in line.split(' ') if '/' not in w]
    if len(words) >= 6 and rnd.random() < .8:
        words.append(rnd.choice(['1/2', '-1/2', '1/40', '-1/40', '3/1', '-1/1000']))
    return ' '.join(words)

def mutate(lines, rnd):
    lines = list(lines)
    for _ in range(rnd.choice([1, 1, 1, 2, 3])):
        kinds = collections.defaultdict(list)
        for i, line in enumerate(lines):
            w = line.split(' ')[0]
            if w in ('v', 's', 'q', 't', 'h', 'f') and len(line.split(' ')) > 2: kinds[w].append(i)
            elif w.isdigit(): kinds['bare'].append(i)
        if not kinds: break
        w = rnd.choice(sorted(kinds))
        i = rnd.choice(kinds[w])
        how = rnd.random()
        if w in 'vq' and how < .8: lines[i] = coordinate(lines[i], rnd)
        elif w == 't' and how < .3: lines[i] = rotate(lines[i], rnd)
        elif w == 't' and how < .5: lines[i] = offset(lines[i], rnd)
        elif w in 'th' and how < .7:
            header = next(j for j in range(i, -1, -1) if lines[j].split(' ')[0] in ('cells', 'hanging'))
            name, n = lines[header].split(' ')
            if rnd.random() < .6: del lines[i]; n = int(n) - 1
            else: lines.insert(i, lines[rnd.choice(kinds[w])]); n = int(n) + 1
            lines[header] = '%s %d' % (name, n)
        elif w == 'bare' and how < .5: lines[i] = ' '.join(reversed(lines[i].split(' ')))
        else: lines[i] = index(lines[i], rnd)
    n = {}
    for line in lines:
        words = line.split(' ')
        if len(words) == 2 and words[1].isdigit(): n.setdefault(words[0], words[1])
    body = '\n'.join(lines[:-1]) + '\n'
    counts = [n.get(k, '0') for k in ('vertices', 'segments', 'facets', 'points', 'cells', 'rows', 'hanging')]
    return body + 'end ' + ' '.join(counts) + ' ' + hashlib.sha256(body.encode()).hexdigest() + '\n'

def answer(binary, path, *options):
    """the exit code, and the last line up to the rule and its line; for exit 2 the error's code and line"""
    p = subprocess.run([binary, path, *options], stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=300)
    last = p.stdout.decode().strip().split('\n')[-1]
    error = re.search(r':(\d+):\d+: error\[(E-[A-Z]+)\]', p.stderr.decode())
    return p.returncode, ' '.join(last.split(' ')[:4]) if p.returncode in (0, 3, 5) else (error.group(2) + ' ' + error.group(1) if error else '')

def differ(a, b):
    """two answers are different verdicts: another exit code or rule; for malformed text, another error or line"""
    return a[0] != b[0] or (a[1].split(' ')[:3] != b[1].split(' ')[:3])

def skip_without(verified):
    """ctest's 77 when the verified checker is not built; an error where it has to be (.ci/run)"""
    if not os.access(verified, os.X_OK):
        print('SKIPPED: there is no %s; ./run proofs builds it (coq, ocaml)' % verified)
        sys.exit(1 if os.environ.get('CONFIDEL_NO_SKIP') else 77)

def main():
    gmp, verified = sys.argv[1], sys.argv[2]
    skip_without(verified)
    count = int(sys.argv[3]) if len(sys.argv) > 3 else 2000
    seed = int(sys.argv[4]) if len(sys.argv) > 4 else 1
    seeds, rnd = parents(), random.Random(seed)
    tally, bad, other_lines = collections.Counter(), 0, 0
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, 'mutant.cert')
        for k in range(count):
            text = mutate(rnd.choice(seeds), rnd)
            open(path, 'w').write(text)
            a, b = answer(gmp, path), answer(verified, path)
            tally[(a[0], a[1].split(' ')[2] if a[0] == 5 else a[1].split(' ')[0])] += 1
            other_lines += a != b and not differ(a, b)
            if differ(a, b):
                bad += 1
                os.makedirs('disagreements', exist_ok=True)
                open('disagreements/%d-%d.cert' % (seed, k), 'w').write(text)
                print('DISAGREE %d-%d: gmp %s, verified %s' % (seed, k, a, b))
    for key, n in sorted(tally.items(), key=str): print(n, *key)
    print('%d mutants, %d disagreements, %d rejections of the same rule that name different lines' % (count, bad, other_lines))
    sys.exit(bad != 0)

if __name__ == '__main__':
    main()
