#!/usr/bin/env python3
"""PM4Sand once more, written from its equations with tensors of the plane and fixed small steps (midpoint rule).

Without arguments it writes tests/unit/solver/pm4sand/paths.csv: random strain paths and the stress and fabric at their
ends, with which pm4sand_twin_test.cpp compares the program. With a number it computes so many of the paths again and
compares them with the table.

Tensors are (a_xx, a_yy, a_xy); stress and strain are compression positive; gamma is engineering shear.
"""
import csv
import math
import pathlib
import random
import sys

PA = 100e3
TABLE = pathlib.Path(__file__).with_name("paths.csv")
STEP = 2.5e-8  # of strain
HALVINGS = 14  # of a step in which the law changes
I = (1.0, 1.0, 0.0)


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + 2.0 * a[2] * b[2]


def comb(*terms):
    return tuple(sum(w * a[k] for w, a in terms) for k in range(3))


def mac(x):
    return x if x > 0.0 else 0.0


class Sand:
    """Parameters by relative density, with the defaults of version 3.1."""

    def __init__(self, dr):
        self.dr = dr
        self.G0 = 167.0 * math.sqrt(46.0 * dr * dr + 2.5)
        self.hpo = 0.5
        self.h0 = max(0.3, (0.25 + dr) / 2.0)
        self.emax, self.emin = 0.8, 0.5
        self.n_b, self.n_d, self.cz = 0.5, 0.1, 250.0
        self.ceps = min(0.5, max(0.2, 0.5 - 1.5 * (dr - 0.55)))
        self.M = 2.0 * math.sin(math.radians(33.0))
        self.nu, self.cgd = 0.3, 2.0
        self.cdr = min(10.0, 5.0 + 25.0 * (dr - 0.35))
        self.ckaf = min(35.0, max(4.0, 5.0 + 220.0 * (dr - 0.26) ** 3))
        self.Q, self.R, self.m = 10.0, 1.5, 0.01


class Point:
    pass


def copy(point):
    other = Point()
    other.__dict__.update(point.__dict__)
    return other


def mean(sig):
    return 0.5 * (sig[0] + sig[1])


def deviator(sig):
    p = mean(sig)
    return (sig[0] - p, sig[1] - p, sig[2])


def state_of(sand, p, e):
    """xi, M^b, M^d"""
    xi = sand.R / (sand.Q - math.log(100.0 * p / PA)) - (sand.emax - e) / (sand.emax - sand.emin)
    if xi <= 0.0:
        return xi, sand.M * math.exp(-sand.n_b * xi), sand.M * math.exp(sand.n_d * xi)
    return xi, sand.M * math.exp(-0.25 * sand.n_b * xi), sand.M * math.exp(4.0 * sand.n_d * xi)


def start(sand, sig):
    pt = Point()
    p = mean(sig)
    pt.sig, pt.szz = sig, sig[0]
    pt.pmin = max(p, PA) / 200.0
    pt.e = sand.emax - (sand.emax - sand.emin) * sand.dr
    xi, mb, md = state_of(sand, max(p, pt.pmin), pt.e)
    pt.zmax = min(20.0, 0.7 * math.exp(-6.1 * xi))
    pt.ado = 2.5 * (math.asin(mb / 2.0) - math.asin(sand.M / 2.0)) / (mb - md) if xi < 0.0 else 1.24
    pt.alpha = comb((1.0 / p, deviator(sig)))
    pt.a_in = pt.a_prev = (0.0, 0.0, 0.0)
    pt.a_true = pt.a_min = pt.a_max = pt.alpha
    pt.z = pt.z_in = (0.0, 0.0, 0.0)
    pt.zcum, pt.zpeak = 0.0, pt.zmax / 1e5
    pt.pzp, pt.zxp = max(p, pt.pmin) / 100.0, -1.0
    return pt


def moduli(sand, pt):
    p = max(mean(pt.sig), pt.pmin)
    s = deviator(pt.sig)
    _, mb, _ = state_of(sand, p, pt.e)
    ratio = math.sqrt(2.0 * dot(s, s)) / p
    csr = 1.0 - 0.5 * min(1.0, (ratio / mb) ** 4)
    c = pt.zcum / pt.zmax
    G = sand.G0 * PA * math.sqrt(p / PA) * csr * (1.0 + c) / (1.0 + sand.cgd * c)
    return G, 2.0 * (1.0 + sand.nu) / (3.0 * (1.0 - 2.0 * sand.nu)) * G


def elastic_rates(sand, pt, de):
    G, K = moduli(sand, pt)
    dv = de[0] + de[1]
    dev = (de[0] - dv / 3.0, de[1] - dv / 3.0, 0.5 * de[2])
    return G, K, dv, dev, comb((2.0 * G, dev), (K * dv, I))


def yield_distance(sand, pt):
    d = comb((1.0, deviator(pt.sig)), (-mean(pt.sig), pt.alpha))
    return math.sqrt(dot(d, d)) - math.sqrt(0.5) * sand.m * mean(pt.sig), d


def rates(sand, pt, de):
    """Changes of stress, sigma_zz, alpha, z, void ratio by a strain on the yield surface."""
    G, K, dv, dev, dsig = elastic_rates(sand, pt, de)
    _, d = yield_distance(sand, pt)
    n = comb((1.0 / math.sqrt(dot(d, d)), d))
    p_true = mean(pt.sig)
    p = max(p_true, pt.pmin)
    s = deviator(pt.sig)
    r = comb((1.0 / p_true, s))
    ratio = math.sqrt(2.0 * dot(s, s)) / p
    xi, mb, md = state_of(sand, p, pt.e)
    zmax, zn, alpha_n = pt.zmax, dot(pt.z, n), dot(pt.alpha, n)
    ab = math.sqrt(0.5) * (mb - sand.m) - alpha_n
    ad = math.sqrt(0.5) * (md - sand.m) - alpha_n
    czin1 = 1.0 - math.exp(-2.0 * abs(dot(pt.z_in, n) - zn) / zmax)
    crot1 = 1.0 + 2.0 * mac(-zn) / (math.sqrt(2.0) * zmax) * (1.0 - czin1)
    adr = math.sqrt(0.5) * (md / crot1 - sand.m) - alpha_n
    a_in = alpha_n - dot(pt.a_in, n)
    a_true = mac(alpha_n - dot(pt.a_true, n))
    # plastic modulus
    czpk1 = pt.zpeak / (pt.zcum + zmax / 5.0)
    czpk2 = min(1.0 - 1e-10, pt.zpeak / (pt.zcum + zmax / 100.0))
    cpzp2 = mac(pt.pzp - p) / (mac(pt.pzp - p) + pt.pmin)
    cka = 1.0 + sand.ckaf / (1.0 + (2.5 * a_true) ** 2) * cpzp2 * czpk1
    cg1 = sand.h0 / 200.0
    crev = (mac(a_in) + cg1) / (a_true + cg1) if alpha_n - dot(pt.a_prev, n) <= 0.0 else 1.0
    kp = G * sand.h0 * ab / math.sqrt(abs(ab) + 1e-6) / (math.exp(mac(a_in)) - 1.0 + cg1)
    kp *= crev * cka / (1.0 + 2.0 * pt.zpeak / zmax * mac(ab) * math.sqrt(1.0 - czpk2))
    # dilatancy
    if adr > 0.0:
        kp = max(0.0, kp)
        hp = sand.hpo * math.exp(-0.7 + 7.0 * mac(0.5 - xi) ** 2)
        crot2 = 1.0 - czpk2
        cdz = max((1.0 - crot2 * math.sqrt(2.0) * pt.zpeak / zmax) * zmax / (zmax + crot2 * pt.zcum),
                  1.0 / (1.0 + zmax / 2.0))
        adc = pt.ado * (1.0 + mac(zn)) / (hp * cdz)
        cin = 2.0 * mac(zn) / (math.sqrt(2.0) * zmax)
        D = min(adc * (a_in + cin) ** 2, 1.5 * pt.ado) * ad / (ad + 0.16)
        D *= min(1.0, max(0.0, (p - 2.0 * pt.pmin) / (16.0 * pt.pmin)))
    else:
        cpzp = 1.0 / (1.0 + (2.5 * p / pt.pzp) ** 5)
        cpmin = 1.0 / (1.0 + (10.0 * pt.pmin / p) ** 2)
        x = czin1 * (pt.zcum - pt.zpeak) / (3.0 * zmax)
        czin2 = (1.0 + x) / (1.0 + 3.0 * x)
        A = pt.ado * czin2 / (pt.zcum ** 2 / zmax * (1.0 - mac(-zn) / (math.sqrt(2.0) * pt.zpeak)) ** 3
                              * sand.ceps ** 2 * cpzp * cpmin * czin1 + 1.0)
        D = A * ad
        rot = A * mac(-zn) / (math.sqrt(2.0) * zmax) * adr / sand.cdr
        if D > rot:
            D += (rot - D) * mac(mb - ratio) / (mac(mb - ratio) + 0.01)
        if p <= 2.0 * pt.pmin:
            D = min(D, -3.5 * pt.ado * mac(mb - md) * (2.0 * pt.pmin - p) / pt.pmin)
    nr = dot(n, r)
    resists = 2.0 * G - K * D * nr
    kp = max(kp, -0.5 * mac(resists))
    L = mac(2.0 * G * dot(n, dev) - nr * mean(dsig)) / max(kp + resists, 0.1 * G)
    dsig = comb((1.0, dsig), (-2.0 * G * L, n), (-K * D * L, I))
    dszz = (K - 2.0 / 3.0 * G) * dv - K * D * L
    b = comb((math.sqrt(0.5) * (mb - sand.m), n), (-1.0, pt.alpha))
    dalpha = comb((L * kp / (p_true * dot(b, n)), b))
    dz = (0.0, 0.0, 0.0)
    if ad < 0.0 and D < 0.0:
        dz = comb((-sand.cz / (1.0 + mac(pt.zcum / (2.0 * zmax) - 1.0)) * L, comb((zmax, n), (1.0, pt.z))))
    return dsig, dszz, dalpha, dz, -(1.0 + pt.e) * dv, n


def moved(pt, change, w=1.0):
    new = copy(pt)
    new.sig = comb((1.0, pt.sig), (w, change[0]))
    new.szz = pt.szz + w * change[1]
    new.alpha = comb((1.0, pt.alpha), (w, change[2]))
    new.z = comb((1.0, pt.z), (w, change[3]))
    new.zcum = pt.zcum + w * math.sqrt(dot(change[3], change[3]) / 2.0)
    new.e = pt.e + w * change[4]
    return new


def elastic_move(sand, pt, de, w):
    de = tuple(w * x for x in de)
    none = (0.0, 0.0, 0.0)

    def change(at):
        G, K, dv, _, dsig = elastic_rates(sand, at, de)
        return dsig, (K - 2.0 / 3.0 * G) * dv, none, none, -(1.0 + at.e) * dv

    return moved(pt, change(moved(pt, change(pt), 0.5)))


def reversal(pt, n):
    if dot(comb((1.0, pt.alpha), (-1.0, pt.a_true)), n) >= 0.0:
        return
    p = max(mean(pt.sig), pt.pmin)
    product = math.sqrt(dot(pt.z, pt.z)) * p
    if product > pt.zxp and p > pt.pzp:
        pt.zxp, pt.pzp = product, p
    pt.z_in, pt.a_true, old = pt.z, pt.alpha, pt.a_in
    pt.a_prev = old
    # components apart: the shear, and the difference of the normal ones
    x, y = pt.alpha[0], pt.alpha[2]
    low, high = [pt.a_min[0], pt.a_min[2]], [pt.a_max[0], pt.a_max[2]]
    new = []
    for k, (a, o, nk) in enumerate(((x, old[0], n[0]), (y, old[2], n[2]))):
        if o > 0.0 or (o == 0.0 and a < 0.0):  # zero is on neither side: by where it turns
            low[k] = min(low[k], a)
        else:
            high[k] = max(high[k], a)
        new.append(max(0.0, low[k]) if nk > 0.0 else min(0.0, high[k]))
    pt.a_min, pt.a_max = (low[0], -low[0], low[1]), (high[0], -high[0], high[1])
    pt.a_in = (new[0], -new[0], new[1]) if y * old[2] > 0.0 else pt.alpha


def side(sand, pt):
    """Where the law changes while it flows: beyond alpha_in of before, beyond the dilatancy surfaces."""
    _, d = yield_distance(sand, pt)
    n = comb((1.0 / math.sqrt(dot(d, d)), d))
    _, _, md = state_of(sand, max(mean(pt.sig), pt.pmin), pt.e)
    zn, alpha_n = dot(pt.z, n), dot(pt.alpha, n)
    crot1 = 1.0 + 2.0 * mac(-zn) / (math.sqrt(2.0) * pt.zmax) * math.exp(-2.0 * abs(dot(pt.z_in, n) - zn) / pt.zmax)
    return (alpha_n <= dot(pt.a_prev, n), math.sqrt(0.5) * (md / crot1 - sand.m) > alpha_n,
            math.sqrt(0.5) * (md - sand.m) < alpha_n, alpha_n < dot(pt.a_true, n))


def step(sand, pt, de, halvings=HALVINGS):
    trial = elastic_move(sand, pt, de, 1.0)
    f, _ = yield_distance(sand, trial)
    if f <= 0.0:
        return trial
    f0, d0 = yield_distance(sand, pt)
    part = 0.0
    G, K, dv, dev, dsig = elastic_rates(sand, pt, de)
    n0 = comb((1.0 / max(1e-300, math.sqrt(dot(d0, d0))), d0))
    r = comb((1.0 / mean(pt.sig), deviator(pt.sig)))
    inward = dot(n0, dsig) - dot(n0, r) * mean(dsig) < 0.0
    if f0 < -1e-9 * mean(pt.sig) or inward:
        low, high = 0.0, 1.0
        if inward:  # from the surface through the inside: look for a point inside
            for k in range(1, 64):
                if yield_distance(sand, elastic_move(sand, pt, de, k / 64.0))[0] < 0.0:
                    low = k / 64.0
        for _ in range(60):
            part = 0.5 * (low + high)
            if yield_distance(sand, elastic_move(sand, pt, de, part))[0] < 0.0:
                low = part
            else:
                high = part
    at = elastic_move(sand, pt, de, part) if part > 0.0 else copy(pt)
    rest = tuple((1.0 - part) * x for x in de)
    _, d = yield_distance(sand, at)
    reversal(at, comb((1.0 / math.sqrt(dot(d, d)), d)))
    middle = moved(at, rates(sand, at, rest), 0.5)
    new = moved(at, rates(sand, middle, rest))
    new.zpeak = max(at.zpeak, math.sqrt(dot(new.z, new.z) / 2.0))
    _, d = yield_distance(sand, new)
    n = comb((1.0 / math.sqrt(dot(d, d)), d))
    new.alpha = comb((1.0 / mean(new.sig), deviator(new.sig)), (-math.sqrt(0.5) * sand.m, n))
    if part == 0.0 and halvings > 0 and side(sand, at) != side(sand, new):
        half = tuple(0.5 * x for x in de)
        return step(sand, step(sand, pt, half, halvings - 1), half, halvings - 1)
    return new


def random_path(number):
    """Density, stress and legs of strain that keep the mean stress in range."""
    chance = random.Random(number)
    dr = chance.uniform(0.3, 0.9)
    vertical = 10.0 ** chance.uniform(4.3, 5.5)
    k0 = chance.uniform(0.45, 1.3)
    tau = chance.uniform(-0.25, 0.25) * vertical
    legs = []
    for _ in range(chance.randint(2, 6)):
        size = 10.0 ** chance.uniform(-4.3, -2.8)
        angle = chance.uniform(0.0, 2.0 * math.pi)
        volume = chance.choice([0.0, 0.0, 0.1, 0.2]) * chance.uniform(-0.3, 1.0)
        shear, normal = math.cos(angle), 0.5 * math.sin(angle)
        legs.append((size * (normal + volume), size * (-normal + volume), size * shear))
    return dr, (k0 * vertical, vertical, tau), legs


def end_of(number, step_size=STEP):
    dr, sig, legs = random_path(number)
    sand = Sand(dr)
    pt = start(sand, sig)
    for leg in legs:
        steps = max(500, math.ceil(max(map(abs, leg)) / step_size))
        de = tuple(x / steps for x in leg)
        for _ in range(steps):
            pt = step(sand, pt, de)
    return dr, sig, legs, pt


def row_of(number):
    dr, sig, legs, pt = end_of(number)
    flat = [x for leg in legs for x in leg] + [0.0] * (18 - 3 * len(legs))
    ends = [*pt.sig, pt.szz, pt.z[0], pt.z[2], pt.zcum, pt.e]
    return [number, repr(dr), *map(repr, sig), len(legs), *map(repr, flat), *(f"{x:.12e}" for x in ends)]


HEAD = (["path", "Dr", "sx", "sy", "txy", "legs"] + [f"{c}{k}" for k in range(6) for c in ("ex", "ey", "g")]
        + ["end_sx", "end_sy", "end_txy", "end_sz", "z_x", "z_xy", "z_cum", "e"])


def main():
    if len(sys.argv) > 1:
        rows = list(csv.reader(TABLE.open()))[1:]
        for row in rows[: int(sys.argv[1])]:
            again = [str(x) for x in row_of(int(row[0]))]
            for a, b in zip(row, again):
                if abs(float(a) - float(b)) > 1e-9 * max(1.0, abs(float(b))):
                    sys.exit(f"path {row[0]}: {a} in the table, {b} computed")
        return
    with TABLE.open("w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(HEAD)
        for number in range(1, 51):
            out.writerow(row_of(number))
            file.flush()


if __name__ == "__main__":
    main()
