"""Every construct of the language in both notations, one pair each."""

WHOLE_MECH = """\
mechanism packet_clamp "Packet clamp of a profile-welding machine"
source "Karpenko, Muzyka, Shishkin 2023, fig. 9"

param a     = 100 mm                          # arm OB
param b     = 250 mm                          # arm OA
param alpha = 12 deg  in 2 deg .. 40 deg
param beta  =  7 deg  in 2 deg .. 40 deg

pivot  O                                      # pin fixed to the ground
slider K along 90 deg                         # guided by the ground
link   OBA                                    # one rigid body through three pins
link   BK

OB = a @ alpha - 90 deg                       # a vector: length @ direction
OA = b @ alpha - 90 deg
BK = @ -90 deg - beta                         # only the direction matters

mirror across 90 deg sharing K                # the left half; K is common to both halves

force P at A along 180 deg
force F at K along  90 deg
find  k = P / F
"""

WHOLE_YAML = """\
mechanism: packet_clamp
title: Packet clamp of a profile-welding machine
source: Karpenko, Muzyka, Shishkin 2023, fig. 9
params:
  a: 100 mm
  b: 250 mm
  alpha: {value: 12 deg, range: 2 deg .. 40 deg}
  beta:  {value: 7 deg,  range: 2 deg .. 40 deg}
pivots: [O]
sliders: {K: 90 deg}
links: [OBA, BK]
geometry:
  OB: a @ alpha - 90 deg
  OA: b @ alpha - 90 deg
  BK: {angle: -90 deg - beta}
mirror: {across: 90 deg, sharing: [K]}
forces:
  P: {at: A, along: 180 deg}
  F: {at: K, along: 90 deg}
find: {k: P / F}
"""

CONSTRUCTS = [
    ("mechc 1", "mechc: 1"),
    ("mechanism m", "mechanism: m"),
    ('mechanism m "A title"', "mechanism: m\ntitle: A title"),
    ('source "fig. 9"', "source: fig. 9"),
    ("param a = 40 mm", "params: {a: 40 mm}"),
    ("param a = 40mm", "params: {a: {value: 40mm}}"),
    ("param a: length", "params: {a: {dimension: length}}"),
    ('param F0: force as "preload"', "params: {F0: {dimension: force, label: preload}}"),
    ("param g = 9.81 m/s^2", "params: {g: 9.81 m/s^2}"),
    ("param b = 2*a in 1 .. 2", "params: {b: {value: 2*a, range: 1 .. 2}}"),
    ("param b in 0.5..2", "params: {b: {range: 0.5..2}}"),
    ('param b = 1 about "why"', "params: {b: {value: 1, about: why}}"),
    ("param e = 1e-3", "params: {e: 1e-3}"),
    ("drive phi from 10 deg to 80 deg", "drive: {phi: 10 deg .. 80 deg}"),
    ("drive phi", "drive: phi"),
    ("drive phi\ndrive psi", "drive: [phi, psi]"),
    ("drive phi from 0 to 1\ndrive s", "drive: {phi: 0 .. 1, s: }"),
    ("drive phi speed 60 rpm", "drive: {phi: {speed: 60 rpm}}"),
    ("drive s from 0 to l speed 2*v", "drive: {s: {range: 0 .. l, speed: 2*v}}"),
    ("find V_C_x/omega_OA", "find: [V_C_x/omega_OA]"),
    ("pivot O", "pivots: [O]"),
    ("pivot O at (x, -y)", "pivots: {O: [x, -y]}"),
    ("pivot O\npivot C at (0, 1 m)", "pivots: [O, {C: [0, 1 m]}]"),
    ("slider A along 0 deg through O", "sliders: {A: {along: 0 deg, through: O}}"),
    ("slider A along -x", "sliders: {A: -x}"),
    ("slider A along perp OB", "sliders: {A: perp OB}"),
    ("slider A along -perp OB", "sliders: {A: -perp OB}"),
    ("slider A along -BC through (0, a)", "sliders: {A: {along: -BC, through: [0, a]}}"),
    ("link ABC", "links: [ABC]"),
    ('link ABC "handle"', "links: {ABC: handle}"),
    ("slide WXY along 30 deg", "slides: {WXY: 30 deg}"),
    ("A at (20 mm, 2*a)", "points: {A: [20 mm, 2*a]}"),
    ("drive OA from 10 deg to 80 deg", "drive: {OA: 10 deg .. 80 deg}"),
    ("slot B in OC", "slots: {B: OC}"),
    ("slot B in OC\nslot B in DE", "slots: {B: [OC, DE]}"),
    ("slot B in OAC about C radius r", "slots: {B: {in: OAC, about: C, radius: r}}"),
    ("slot B in OC guiding BDE", "slots: {B: {in: OC, guiding: BDE}}"),
    ("telescope AB", "telescopes: [AB]"),
    ("gear O1 r1, O2 m*z/2", "gears: [{O1: r1, O2: m*z/2}]"),
    ("gear O1 r1, O2 r2 inner", "gears: [{O1: r1, O2: r2, inner: true}]"),
    ("gear O r1 on OS, A r2", "gears: [{O: r1 on OS, A: r2}]"),
    (
        "gear O r1 + 2*r2 on ground, A r2 inner",
        "gears: [{O: r1 + 2*r2 on ground, A: r2, inner: true}]",
    ),
    ("belt O1 r1 on O1B, O2 r2 on O2C", "belts: [{O1: r1 on O1B, O2: r2 on O2C}]"),
    ("rope A, K along -y, B", "ropes: ['A, K along -y, B']"),
    ("rack A on O r", "racks: [{A: O, radius: r}]"),
    ("contact A on BC normal 30 deg", "contacts: {A: {with: BC, normal: 30 deg}}"),
    ("belt O1 r1, O2 20 mm crossed", "belts: [{O1: r1, O2: 20 mm, crossed: true}]"),
    ("screw A pitch p on OB", "screws: {A: {pitch: p, link: OB}}"),
    ("AB = l @ alpha", "geometry: {AB: l @ alpha}"),
    ("AB = 2*l @ CD", "geometry: {AB: {length: 2*l, angle: CD}}"),
    ("AB = @ alpha", "geometry: {AB: {angle: alpha}}"),
    ("AB = l", "geometry: {AB: l}"),
    ("OC = (x, atan2(y, x))", "geometry: {OC: [x, 'atan2(y, x)']}"),
    ("angle ABC = gamma", "geometry: {ABC: gamma}"),
    ("assembly ABC ccw", "assembly: {ABC: ccw}"),
    ("assembly B forward", "assembly: {B: forward}"),
    ("mirror across y sharing K L'", "mirror: {across: y, sharing: [K, L']}"),
    ("copies 3 sharing A", "copies: {n: 3, sharing: [A]}"),
    ("force P at A along 180 deg", "forces: {P: {at: A, along: 180 deg}}"),
    ("force T = f*R at C along x", "forces: {T: {at: C, along: x, is: f*R}}"),
    ("force F at P on NP along -y", "forces: {F: {at: P, link: NP, along: -y}}"),
    ("force F at K along y times 1/2", "forces: {F: {at: K, along: y, times: 1/2}}"),
    ("torque M on OA", "torques: {M: {link: OA}}"),
    ("torque M = r*P on OA times 2", "torques: {M: {link: OA, is: r*P, times: 2}}"),
    ("actuator P between A and B", "actuators: {P: {between: [A, B]}}"),
    ("actuator P between A on OA and B", "actuators: {P: {between: [A on OA, B]}}"),
    (
        "spring 5 N/mm between A and B free l0",
        "springs: [{between: [A, B], rate: 5 N/mm, free: l0}]",
    ),
    (
        "spring c between A and B on BCD free l0",
        "springs: [{between: [A, B on BCD], rate: c, free: l0}]",
    ),
    ("weight W mass m at G on OGA", "weights: {W: {mass: m, at: G, link: OGA}}"),
    ("load Q on AB along -y", "loads: {Q: {over: AB, along: -y}}"),
    (
        "load Q intensity q to 2*q on AB along -y times 2",
        "loads: {Q: {intensity: q, to: 2*q, over: AB, along: -y, times: 2}}",
    ),
    ("weight W mass m at G\ngravity along -y", "weights: {W: {mass: m, at: G}}\ngravity: -y"),
    (
        "friction pins 0.1 diameter 20 mm coulomb",
        "friction: {pins: {f: 0.1, diameter: 20 mm, pin_law: coulomb}}",
    ),
    (
        "friction pin A f diameter d on AB",
        "friction: {A: {f: f, diameter: d, link: AB}}",
    ),
    ("friction slider K mu", "friction: {K: {guide: mu}}"),
    (
        "friction slider K mu guide s overhang l edges",
        "friction: {K: {guide: mu, length: s, overhang: l, guide_law: edges}}",
    ),
    (
        "friction roller A f1 axle d wheel D",
        "friction: {A: {roller: f1, axle: d, wheel: D}}",
    ),
    ("friction contact A mu", "friction: {A: {contact: mu}}"),
    ("friction gear O1 c", "friction: {O1: {gear: c}}"),
    ("friction belt O1 c", "friction: {O1: {belt: c}}"),
    ("friction rack A c", "friction: {A: {rack: c}}"),
    ("friction screw A mu thread d", "friction: {A: {screw: mu, thread: d}}"),
    ("friction collar A mu mean d", "friction: {A: {collar: mu, mean: d}}"),
    (
        "friction collar A mu outer D inner d pressure",
        "friction: {A: {collar: mu, outer: D, inner: d, collar_law: pressure}}",
    ),
    (
        "friction collar O mu mean d thrust W faces 2 on OA",
        "friction: {O: {collar: mu, mean: d, thrust: W, faces: 2, collar_link: OA}}",
    ),
    ("friction rope B mu wrap theta", "friction: {B: {rope: mu, wrap: theta}}"),
    (
        "friction rope O mu wrap theta drum D on OC",
        "friction: {O: {rope: mu, wrap: theta, drum: D, drum_link: OC}}",
    ),
    (
        "friction pin A f diameter d\nfriction slider A mu",
        "friction: {A: {f: f, diameter: d, guide: mu}}",
    ),
    ("motion releasing", "motion: releasing"),
    ("efficiency eta", "efficiency: eta"),
    ("let F = m*(g + w)/(2*f)*lambda", "let: {F: m*(g + w)/(2*f)*lambda}"),
    ('sheet grip "Friction grip"', "sheet: grip\ntitle: Friction grip"),
    (
        'table m "Table 4.9" = 1: 0.388, 0.5: 0.54',
        "tables: {m: {rows: [[1, 0.388], [0.5, 0.54]], source: Table 4.9}}",
    ),
    ("table q = 0 mm: 1, 5 mm: 2*3", "tables: {q: [[0 mm, 1], [5 mm, 2*3]]}"),
    ("list bores = 32 mm, 40 mm", "lists: {bores: [32 mm, 40 mm]}"),
    ('list dowels "ISO 2340" = 4 mm', "lists: {dowels: {sizes: [4 mm], source: ISO 2340}}"),
    (
        'use cylinder as cyl (P = 2*F, p = 0.6 MPa)\nuse "parts/pin.mech" as bolt',
        "use: {cyl: {name: cylinder, with: {P: 2*F, p: 0.6 MPa}}, bolt: parts/pin.mech}",
    ),
    (
        "use toggle as T (l = 2*a) at (1 mm, 0 mm) turned 90 deg joining T.C = B, T.D' = S.E"
        " without F, alpha\nuse lever as L joining L.A = C",
        "use: {T: {name: toggle, with: {l: 2*a}, at: [1 mm, 0 mm], turned: 90 deg,"
        " joining: {T.C: B, T.D': S.E}, without: [F, alpha]},"
        " L: {name: lever, joining: {L.A: C}}}",
    ),
    ("force F at T.K on T.KB along -T.OB", "forces: {F: {at: T.K, link: T.KB, along: -T.OB}}"),
    ("let a = phi_T.OB - R_T.O_x", "let: {a: phi_T.OB - R_T.O_x}"),
    (
        'translate "arm" en "lever" uk "плече"\ntranslate "on" ru "да"',
        'translate: [{text: arm, en: lever, uk: плече}, {text: "on", ru: да}]',
    ),
    ("let m = q at 2*r/d", "let: {m: q at 2*r/d}"),
    ("let D = next D_min in bores in mm", "let: {D: {value: next D_min in bores, unit: mm}}"),
    (
        'let s = M/W in N/mm^2 as "bending"',
        "let: {s: {value: M/W, unit: N/mm^2, label: bending}}",
    ),
    ("let K = 1.1 when v < 1 m/s else 1.3", "let: {K: 1.1 when v < 1 m/s else 1.3}"),
    (
        "let K = a when 0 < x < 1 and y > 0, b when x >= 1 else c when y < 0 else d",
        "let: {K: 'a when 0 < x < 1 and y > 0, b when x >= 1 else c when y < 0 else d'}",
    ),
    ("find k = P / F", "find: {k: P / F}"),
    ("find P, V_D/V_A, R_B on AB", "find: [P, V_D/V_A, R_B on AB]"),
    ("find omega_OB/V_A\nfind N = N_AB", "find: [omega_OB/V_A, N = N_AB]"),
    ("find R = R_B on AB", "find: {R: R_B on AB}"),
    (
        "report scheme, bodies\nreport k, plot k over alpha",
        "report: [scheme, bodies, k, plot k over alpha]",
    ),
    ("require 0 deg < alpha + theta <= 90 deg", "require: [0 deg < alpha + theta <= 90 deg]"),
    (
        "expect k = 7.1407 at alpha = 35 deg, beta = 7 deg",
        "expect: ['k = 7.1407 at alpha = 35 deg, beta = 7 deg']",
    ),
    ("require a != b", "require: a != b"),
    ("expect k = 2*b/a*ctg(alpha)", "expect: [k = 2*b/a*cot(alpha)]"),
]
