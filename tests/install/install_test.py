#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""install_test.py BUILD COMPILER: installs into a folder of its own, builds examples/embed.cpp against it with CMake and with pkg-config, makes the
Debian package and looks into it. Skipped with sanitizers: the libraries of the build need their flags."""
import os
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = os.path.normpath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
CONSUMER = """cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
set(CMAKE_CXX_STANDARD 20)
find_package(confidel 0.1 REQUIRED)
add_executable(embed %s)
target_link_libraries(embed PRIVATE confidel::certificate confidel::core)
get_target_property(checker confidel::check LOCATION)
file(WRITE ${CMAKE_BINARY_DIR}/checker.txt ${checker})
"""
failures = 0


def expect(good, message):
    global failures
    if not good:
        failures += 1
        print("FAILED " + message, flush=True)
    return good


def run(*command, **options):
    done = subprocess.run([str(part) for part in command], capture_output=True, text=True, **options)
    expect(done.returncode == 0, "%s: %d\n%s%s" % (" ".join(map(str, command)), done.returncode, done.stdout[-2000:], done.stderr[-2000:]))
    return done.stdout


def use(program, prefix, folder):
    """The embedding program: a certificate that the installed checker accepts."""
    certificate = os.path.join(folder, "w3.cert")
    environment = dict(os.environ, PATH=os.path.join(prefix, "bin") + os.pathsep + os.environ["PATH"])
    out = run(program, os.path.join(ROOT, "examples/w3.smesh"), certificate, env=environment)
    expect(out.endswith("s VERIFIED\n") and "Steiner points" in out, "the embedding program says %r" % out)
    expect(os.path.isfile(certificate) and not [name for name in os.listdir(folder) if "partial" in name], "the certificate is there, and nothing else")
    os.unlink(certificate)


def check_prefix(prefix, folder):
    for path in ("bin/confidel", "bin/confidel-check", "share/man/man1/confidel.1", "share/man/man1/confidel-conform.1", "share/man/man1/confidel-check.1",
                 "share/bash-completion/completions/confidel", "share/zsh/vendor-completions/_confidel", "share/fish/vendor_completions.d/confidel.fish"):
        expect(os.path.getsize(os.path.join(prefix, path)) > 0 if os.path.isfile(os.path.join(prefix, path)) else False, "not installed: " + path)
    confidel = os.path.join(prefix, "bin/confidel")
    for name in ("confidel", "confidel-conform"):
        with open(os.path.join(prefix, "share/man/man1", name + ".1")) as file:
            expect(file.read() == run(confidel, "manual", *name.split("-")[1:]), "%s.1 is stale" % name)
    with open(os.path.join(prefix, "share/man/man1/confidel-check.1")) as file:
        page = file.read().replace("\\-", "-")
    for option in re.findall(r"^  (--[a-z-]+)", run(os.path.join(prefix, "bin/confidel-check"), "--help"), re.M):
        expect(option in page, "checkers/gmp/confidel-check.1 has no " + option)
    run(confidel, "conform", os.path.join(ROOT, "examples/cube.off"), "-o", os.path.join(folder, "cube.cert"))
    os.unlink(os.path.join(folder, "cube.cert"))


def check_cmake(prefix, folder):
    source, build = os.path.join(folder, "consumer"), os.path.join(folder, "consumer-build")
    os.mkdir(source)
    with open(os.path.join(source, "CMakeLists.txt"), "w") as file:
        file.write(CONSUMER % os.path.join(ROOT, "examples/embed.cpp"))
    run("cmake", "-S", source, "-B", build, "-DCMAKE_PREFIX_PATH=" + prefix, "-DCMAKE_BUILD_TYPE=Release")
    run("cmake", "--build", build)
    work = os.path.join(folder, "work")
    os.mkdir(work)
    use(os.path.join(build, "embed"), prefix, work)
    with open(os.path.join(build, "checker.txt")) as file:
        expect(os.path.realpath(file.read()) == os.path.realpath(os.path.join(prefix, "bin/confidel-check")), "confidel::check is another program")


def check_pkg_config(prefix, folder, compiler):
    places = [place for place in (os.path.join(prefix, "lib", sub, "pkgconfig") for sub in ("", "x86_64-linux-gnu")) if os.path.isdir(place)]
    environment = dict(os.environ, PKG_CONFIG_PATH=os.pathsep.join(places))
    flags = {option: run("pkg-config", option, "confidel", env=environment).split() for option in ("--cflags", "--libs")}
    program = os.path.join(folder, "embed")
    run(compiler, "-std=c++20", *flags["--cflags"], os.path.join(ROOT, "examples/embed.cpp"), "-o", program, *flags["--libs"])
    use(program, prefix, os.path.join(folder, "work"))


def check_package(build, folder):
    out = os.path.join(folder, "package")
    run("cpack", "-G", "DEB", "--config", os.path.join(build, "CPackConfig.cmake"), "-B", out, cwd=folder)
    packages = [name for name in os.listdir(out) if name.endswith(".deb")]
    if not expect(len(packages) == 1, "packages: %s" % packages):
        return
    package = os.path.join(out, packages[0])
    depends = run("dpkg-deb", "-f", package, "Depends")
    for library in ("libc6", "libgmp10", "libstdc++6", "libssl3", "libzstd1", "libfmt9"):
        expect(re.search(r"\b%s\b" % re.escape(library), depends), "the package does not depend on %s: %s" % (library, depends))
    listing = run("dpkg-deb", "-c", package)
    for path in ("./usr/bin/confidel", "./usr/bin/confidel-check", "./usr/share/man/man1/confidel.1", "./usr/share/doc/confidel/README.md"):
        expect(re.search(re.escape(path) + r"(\.gz)?$", listing, re.M), "the package has no " + path)
    expect("/proofs/api/confidel.h" in listing and "libconfidel_core.a" in listing, "the package has no C++ library")
    unpacked = os.path.join(folder, "unpacked")
    run("dpkg-deb", "-x", package, unpacked)
    run(os.path.join(unpacked, "usr/bin/confidel"), "info", os.path.join(ROOT, "examples/cube.off"))


def main():
    build, compiler = os.path.abspath(sys.argv[1]), sys.argv[2]
    with open(os.path.join(build, "CMakeCache.txt")) as file:
        if re.search(r"^CONFIDEL_SANITIZE:BOOL=ON", file.read(), re.M):
            print("skipped: a build with sanitizers")
            sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        prefix = os.path.join(folder, "prefix")
        run("cmake", "--install", build, "--prefix", prefix)
        check_prefix(prefix, folder)
        check_cmake(prefix, folder)
        check_pkg_config(prefix, folder, compiler)
        if shutil.which("dpkg-shlibdeps") and shutil.which("cpack"):
            check_package(build, folder)
        else:
            print("no dpkg-shlibdeps: the package is not made")
    print("%d failures" % failures)
    sys.exit(1 if failures else 0)


main()
