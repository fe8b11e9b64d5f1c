#!/usr/bin/env python3
"""Whether the compiler has made vectors of the soil laws' kernels: python3 tests/vectors.py PROGRAM

Their functions for AVX2, as objdump shows them, must have ten times as many packed operations as scalar ones. No number
shows it where they have not: the laws take up to three times as long.
"""
import re
import subprocess
import sys

KERNEL = re.compile(r"^[0-9a-f]+ <.*::(advance_\w*(?:order|points)\(quicksand::(?:UbcSand|Pm4Sand) const&.*\.avx2\])>:")
FUNCTION = re.compile(r"^[0-9a-f]+ <")
OPERATION = re.compile(r"\tv(?:add|sub|mul|div|sqrt|max|min)([sp])d\b")
LEAST_KERNELS, LEAST_PACKED = 9, 10  # eight forms of UBCSAND and PM4Sand; per scalar operation


def operations(program):
    """Scalar and packed operations of each kernel."""
    listing = subprocess.run(["objdump", "--disassemble", "--demangle", "--no-show-raw-insn", program],
                             check=True, capture_output=True, text=True).stdout
    counts, kernel = {}, None
    for line in listing.splitlines():
        if FUNCTION.match(line):
            found = KERNEL.match(line)
            kernel = found[1] if found else None
        elif kernel and (found := OPERATION.search(line)):
            counts.setdefault(kernel, {"s": 0, "p": 0})[found[1]] += 1
    return counts


def main():
    counts = operations(sys.argv[1])
    scalar = {kernel: count for kernel, count in counts.items() if count["p"] < LEAST_PACKED * count["s"]}
    for kernel, count in scalar.items():
        print(f"{kernel}: {count['s']} scalar and {count['p']} packed operations")
    if len(counts) < LEAST_KERNELS:
        print(f"{len(counts)} kernels for AVX2 in {sys.argv[1]}, expected {LEAST_KERNELS}")
    return 1 if scalar or len(counts) < LEAST_KERNELS else 0


if __name__ == "__main__":
    sys.exit(main())
