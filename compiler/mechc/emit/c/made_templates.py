"""The templates of this folder as functions, made by ``mechc.emit.make_templates``."""

from collections.abc import Mapping
from typing import Any

from ..render import turns


def _arcs(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\n/*\n * Residuals and slopes (by rows, by the unknowns and last by the share) at unknowns and a share of\n * the way, for what is given at its end.\n */\ntypedef void mechc_sides(const double *found, double aim, const double *given, double *residual, double *slope);\n\n/* Solves matrix*x = right as mechc_eliminate does, for a number of unknowns that is not known here. */\nstatic int mechc_solve(size_t n, double *matrix, double *right)\n{\n    size_t i, j, k;\n    int sign = 1;\n    for (k = 0; k < n; ++k) {\n        size_t best = k;\n        for (i = k + 1; i < n; ++i) {\n            best = fabs(matrix[i*n + k]) > fabs(matrix[best*n + k]) ? i : best;\n        }\n        if (!(fabs(matrix[best*n + k]) > 0.0 && fabs(matrix[best*n + k]) < HUGE_VAL)) {\n            return 0;\n        }\n        for (j = k; j <= n && best != k; ++j) {\n            double *const upper = j < n ? matrix + k*n + j : right + k;\n            double *const lower = j < n ? matrix + best*n + j : right + best;\n            const double moved = *upper;\n            *upper = *lower;\n            *lower = moved;\n        }\n        sign = (matrix[k*n + k] < 0.0) == (best != k) ? sign : -sign;\n        for (i = k + 1; i < n; ++i) {\n            const double times = matrix[i*n + k]/matrix[k*n + k];\n            for (j = k + 1; j < n; ++j) {\n                matrix[i*n + j] -= times*matrix[k*n + j];\n            }\n            right[i] -= times*right[k];\n        }\n    }\n    for (k = n; k-- > 0;) {\n        for (j = k + 1; j < n; ++j) {\n            right[k] -= matrix[k*n + j]*right[j];\n        }\n        right[k] /= matrix[k*n + k];\n    }\n    return sign;\n}\n\n/* The equations at a point, the unknowns and then the share, and a direction as the last row. */\nstatic void mechc_border(size_t n, mechc_sides *sides, const double *given, const double *point,\n    const double *across, double *right, double *matrix)\n{\n    size_t j;\n    sides(point, point[n], given, right, matrix);\n    for (j = 0; j <= n; ++j) {\n        matrix[n*(n + 1) + j] = across[j];\n    }\n    right[n] = 0.0;\n}\n\n/*\n * The direction of the branch that goes on from one before it. Returns the sign of the determinant\n * by the unknowns, 0 where there is no such direction.\n */\nstatic int mechc_tangent(size_t n, mechc_sides *sides, const double *given, const double *point,\n    const double *before, double *tangent, double *matrix)\n{\n    double square = 0.0;\n    size_t i;\n    int sign;\n    mechc_border(n, sides, given, point, before, tangent, matrix);\n    for (i = 0; i <= n; ++i) {\n        tangent[i] = i < n ? 0.0 : 1.0;\n    }\n    sign = mechc_solve(n + 1, matrix, tangent);\n    for (i = 0; i <= n; ++i) {\n        square += tangent[i]*tangent[i];\n    }\n    for (i = 0; i <= n; ++i) {\n        tangent[i] /= sqrt(square);\n    }\n    return sign;\n}\n\n/* Moves a point square to a direction onto the branch, on a side of it if that is not 0. */\nstatic int mechc_onto(size_t n, mechc_sides *sides, const double *given, double *point,\n    const double *across, double most, int side, double *change, double *matrix)\n{\n    const double near = side != 0 ? 0.0 : ', str(_known["arcs"].EXACT_ON_THE_WAY), '*most;\n    const double tiny = near > ', str(_known["real"].tiny), ' ? near : ', str(_known["real"].tiny), ';\n    size_t i;\n    int count;\n    for (count = 0; count < ', str(_known["arcs"].POINT_CORRECTIONS), '; ++count) {\n        const double last = most/', str(_known["arcs"].CONTRACTION), ';\n        double square = 0.0, size;\n        int sign;\n        mechc_border(n, sides, given, point, across, change, matrix);\n        sign = mechc_solve(n + 1, matrix, change);\n        for (i = 0; i <= n; ++i) {\n            square += change[i]*change[i];\n        }\n        size = sqrt(square);\n        if (sign == 0 || !(size <= ', str(_known["real"].tiny), ' || size <= most)) {\n            return 0;\n        }\n        for (i = 0; i <= n; ++i) {\n            point[i] -= change[i];\n        }\n        if (size <= tiny || size*size*size <= ', str(_known["real"].rounding), '*last*last) {\n            return side == 0 || sign == side;\n        }\n        most = ', str(_known["arcs"].CONTRACTION), "*size;\n    }\n    return 0;\n}\n\n/* Newton's method from a point to a solution with all of the share; returns 0 where it finds none. */\nstatic int mechc_straight(size_t n, mechc_sides *sides, const double *given, double *point,\n    const double *along, double *change, double *matrix)\n{\n    size_t i;\n    int count;\n    for (count = 0; count < ", str(_known["arcs"].FOLD_CORRECTIONS), '; ++count) {\n        double square = 0.0;\n        mechc_border(n, sides, given, point, along, change, matrix);\n        if (!mechc_solve(n + 1, matrix, change)) {\n            return 0;\n        }\n        for (i = 0; i <= n; ++i) {\n            square += change[i]*change[i];\n            point[i] -= change[i];\n        }\n        if (sqrt(square) <= ', str(_known["real"].tiny), ') {\n            return point[n - 1] > 0.0;\n        }\n    }\n    return 0;\n}\n\n/*\n * Follows a branch of solutions by its arc length, past places where it is steep. Returns 0 at the\n * end of the way, 1 where it turns back before, at a fold between two points that are next to each\n * other, 2 where neither is found in ', str(_known["arcs"].MOST_POINTS), ' points. ``found`` is the start, and becomes the solution.\n */\nstatic int mechc_arcs(size_t n, mechc_sides *sides, const double *given, double *found, double *work)\n{\n    double *along = work, *point = along + n + 1, *tangent = point + n + 1, *ahead = tangent + n + 1;\n    double *turned = ahead + n + 1, *matrix = turned + n + 1;\n    double arc = ', str(_known["arcs"].FIRST), ';\n    size_t i;\n    int count, side;\n    for (i = 0; i <= n; ++i) {\n        along[i] = i < n ? 0.0 : 1.0;\n        point[i] = i < n ? found[i] : 0.0;\n    }\n    side = mechc_tangent(n, sides, given, point, along, tangent, matrix);\n    for (count = 0; side && count < ', str(_known["arcs"].MOST_POINTS), ' && arc >= ', str(_known["real"].least), '; ++count) {\n        const double rest = (1.0 - point[n])/tangent[n];\n        const int is_last = arc >= rest;\n        const double length = is_last ? rest : arc;\n        double cosine = 0.0, bent;\n        int there, here, rises;\n        for (i = 0; i <= n; ++i) {\n            ahead[i] = point[i] + length*tangent[i];\n        }\n        ahead[n] = is_last ? 1.0 : ahead[n];\n        there = mechc_onto(n, sides, given, ahead, is_last ? along : tangent, ', str(_known["arcs"].FIRST_CORRECTION_OF_ARC), '*length,\n            is_last ? side : 0, turned, matrix);\n        if (there && is_last) {\n            for (i = 0; i < n; ++i) {\n                found[i] = ahead[i];\n            }\n            return 0;\n        }\n        here = there ? mechc_tangent(n, sides, given, ahead, tangent, turned, matrix) : 0;\n        for (i = 0; here && i <= n; ++i) {\n            cosine += turned[i]*tangent[i];\n        }\n        rises = turned[n] > 0.0;\n        bent = rises ? ', str(_known["arcs"].STRAIGHT_COSINE), ' : ', str(_known["arcs"].FOLDED), ';\n        bent = here == side && (rises || length <= ', str(_known["real"].sharp), ') ? ', str(_known["arcs"].ARC_COSINE), ' : bent;\n        if (!(cosine >= bent && (rises || here == side) && ahead[n] <= 1.0)) {\n            arc = 0.5*length;\n            continue;\n        }\n        if (turned[n] <= 0.0) { /* made by what is rounded off if a solution is found from the start */\n            for (i = 0; i <= n; ++i) {\n                ahead[i] = i < n ? found[i] : 1.0;\n            }\n            there = mechc_straight(n, sides, given, ahead, along, turned, matrix);\n            for (i = 0; there && i < n; ++i) {\n                found[i] = ahead[i];\n            }\n            return there ? 0 : 1;\n        }\n        for (i = 0; i <= n; ++i) {\n            point[i] = ahead[i];\n            tangent[i] = turned[i];\n        }\n        side = here;\n        if (cosine >= ', str(_known["arcs"].EASY), ') {\n            arc = 2.0*arc < ', str(_known["arcs"].LONGEST), ' ? 2.0*arc : ', str(_known["arcs"].LONGEST), ';\n        }\n    }\n    return 2;\n}\n']
    return "".join(_parts)


def _checks(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\n', str(_known["checks"].single), '\n{\n']
    for line in _known["checks"].body:
        _parts += ['    ', str(line), '\n']
    for loop, condition in turns(_known["checks"].conditions):
        _parts += ['    if (!(', str(condition), ')) {\n        return ', str(loop.index), ';\n    }\n']
    _parts += ['    return 0;\n}\n\n', str(_known["checks"].batch), '\n{\n    for (size_t ', str(_known["checks"].loop), ' = 0; ', str(_known["checks"].loop), ' < ', str(_known["checks"].number), '; ++', str(_known["checks"].loop), ') {\n        ', str(_known["checks"].status), '[', str(_known["checks"].loop), '] = ', str(_known["checks"].call), ';\n    }\n}\n']
    return "".join(_parts)


def _circular(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    if ('sin' in _known["helpers"]):
        _parts += ['\nstatic inline double mechc_sin(double x)\n{\n    return mechc_sine(x, 0.0);\n}\n']
    if ('cos' in _known["helpers"]):
        _parts += ['\nstatic inline double mechc_cos(double x)\n{\n    return mechc_sine(x, 0.5);\n}\n']
    if ('sin_of_pair' in _known["helpers"]):
        _parts += ['\nstatic inline double mechc_sin_of_pair(double x)\n{\n    return mechc_circular(x, 0u);\n}\n']
    if ('cos_of_pair' in _known["helpers"]):
        _parts += ['\nstatic inline double mechc_cos_of_pair(double x)\n{\n    return mechc_circular(x, 1u);\n}\n']
    if ('tan' in _known["helpers"]):
        _parts += ['\nstatic inline double mechc_tan(double x)\n{\n    return mechc_circular(x, 0u)/mechc_circular(x, 1u);\n}\n']
    return "".join(_parts)


def _circular_double(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ["\n/*\n * sin(x + quarter*pi/2) without a branch, so that loops over it become vector code:\n * Cody and Waite's reduction in three parts and the polynomials of fdlibm (Sun\n * Microsystems, 1993), within 2.5 ulp. NaN beyond 2^20 rad, where the caller asks libm.\n * Sine and cosine of one angle share all but the last lines.\n */\nstatic inline double mechc_circular(double x, uint64_t quarter)\n{\n    const double shifter = 6755399441055744.0; /* 1.5*2^52: the sum's last bits count quarters */\n    const double shifted = x*6.36619772367581382433e-01 + shifter;\n    const double turns = shifted - shifter;\n    const double beyond = x*1.71e302; /* infinite beyond 2^20, and infinity less itself is NaN */\n    const double r = x - turns*1.57079632673412561417e+00 - turns*6.07710050630396597660e-11\n        - (turns*2.02226624879595063154e-21 + (beyond - beyond));\n    const double z = r*r, zz = z*z;\n    const double s = r + z*r*(-1.66666666666666324348e-01 + z*8.33333333332248946124e-03\n        + zz*(-1.98412698298579493134e-04 + z*2.75573137070700676789e-06\n        + zz*(-2.50507602534068634195e-08 + z*1.58969099521155010221e-10)));\n    const double c = 1.0 - 0.5*z + zz*(4.16666666666666019037e-02\n        - z*1.38888888888741095749e-03 + zz*(2.48015872894767294178e-05\n        - z*2.75573143513906633035e-07 + zz*(2.08757232129817482790e-09\n        - z*1.13596475577881948265e-11)));\n    uint64_t count, sine, cosine, chosen;\n    double result;\n    memcpy(&count, &shifted, sizeof count);\n    memcpy(&sine, &s, sizeof sine);\n    memcpy(&cosine, &c, sizeof cosine);\n    chosen = quarter ? cosine : sine; /* the other one in odd quarters */\n    chosen ^= (sine ^ cosine) & (0u - (count & 1u));\n    chosen ^= ((count + quarter) & 2u) << 62;\n    memcpy(&result, &chosen, sizeof result);\n    return result;\n}\n"]
    return "".join(_parts)


def _circular_float(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ["\n/*\n * sin(x + quarter*pi/2) without a branch, so that loops over it become vector code:\n * Cody and Waite's reduction in three parts and the polynomials of Cephes (S. Moshier,\n * 1989). NaN beyond 2^13 rad, where the caller asks libm. Sine and cosine of one angle\n * share all but the last lines.\n */\nstatic inline double mechc_circular(double x, uint32_t quarter)\n{\n    const double shifter = 12582912.0; /* 1.5*2^23: the sum's last bits count quarters */\n    const double shifted = x*0.636619772 + shifter;\n    const double turns = shifted - shifter;\n    const double beyond = x*4.15e34; /* infinite beyond 2^13, and infinity less itself is NaN */\n    const double r = x - turns*1.5703125 - turns*4.837512969970703125e-4\n        - (turns*7.54978995489188216e-8 + (beyond - beyond));\n    const double z = r*r;\n    const double s = r + z*r*(-1.6666654611e-1 + z*(8.3321608736e-3 - z*1.9515295891e-4));\n    const double c = 1.0 - 0.5*z + z*z*(4.166664568298827e-2\n        - z*(1.388731625493765e-3 - z*2.443315711809948e-5));\n    uint32_t count, sine, cosine, chosen;\n    double result;\n    memcpy(&count, &shifted, sizeof count);\n    memcpy(&sine, &s, sizeof sine);\n    memcpy(&cosine, &c, sizeof cosine);\n    chosen = quarter ? cosine : sine; /* the other one in odd quarters */\n    chosen ^= (sine ^ cosine) & (0u - (count & 1u));\n    chosen ^= ((count + quarter) & 2u) << 30;\n    memcpy(&result, &chosen, sizeof result);\n    return result;\n}\n"]
    return "".join(_parts)


def _common(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    for c in _known["commons"]:
        _parts += ['\n/* Fills in what many of the functions below have in common. */\n', str(c.head), '\n{\n']
        for line in c.body:
            _parts += ['    ', str(line), '\n']
        _parts += ['}\n']
    return "".join(_parts)


def macro_remark(lines: Any) -> str:
    _parts: list[str] = []
    _parts += ['/*\n']
    for line in lines:
        _parts += [' *', str((' ' if line else '')), str(line), '\n']
    _parts += [' */\n']
    return "".join(_parts)


def macro_restrict() -> str:
    _parts: list[str] = []
    _parts += ['#ifndef MECHC_RESTRICT\n#if defined(__GNUC__) || defined(_MSC_VER)\n#define MECHC_RESTRICT __restrict\n#elif !defined(__cplusplus) && defined(__STDC_VERSION__) && __STDC_VERSION__ >= 199901L\n#define MECHC_RESTRICT restrict\n#else\n#define MECHC_RESTRICT\n#endif\n#endif\n']
    return "".join(_parts)


def macro_by_parameters(parameters: Any) -> str:
    _parts: list[str] = []
    _parts += ['\n/*\n * All parameters by name. The defaults are the values of the description, NAN where it has none:\n * copy them, set what is to differ, and pass the copy on. Each function below gives what the\n * one without _of gives for these values; one with _n_of takes the elements 0 .. n - 1 of an\n * array of structs, and its arrays must not overlap.\n */\ntypedef struct ', str(parameters.struct), ' {\n']
    for field in parameters.fields:
        _parts += ['    double ', str(field.name), '; /* ', str(field.words), ' */\n']
    _parts += ['} ', str(parameters.struct), ';\n\nextern const ', str(parameters.struct), ' ', str(parameters.defaults), ';\n\n']
    for f in parameters.functions:
        _parts += [str(f.head), ';\n']
    return "".join(_parts)


def macro_declarations(functions: Any, parameters: Any) -> str:
    _parts: list[str] = []
    for f in functions:
        _parts += ['\n', macro_remark(f.remarks), str(f.single), ';\n', str(f.batch), ';\n']
    if parameters:
        _parts += [macro_by_parameters(parameters)]
    return "".join(_parts)


def _declarations(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    return "".join(_parts)


def _eliminate(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\n#if defined(__OPTIMIZE_SIZE__) || !defined(__OPTIMIZE__)\n#define MECHC_UNROLL\n#elif defined(__clang__)\n#define MECHC_UNROLL _Pragma("unroll")\n#elif defined(__GNUC__) && __GNUC__ >= 8\n#define MECHC_UNROLL _Pragma("GCC unroll 4")\n#else\n#define MECHC_UNROLL\n#endif\n\n/*\n * Solves matrix*x = right for n unknowns in place, rows exchanged for the largest pivot:\n * right becomes x. Returns the sign of the determinant, 0 where there is no solution.\n * Unrolled, a small matrix stays in registers.\n */\nstatic inline int mechc_eliminate(size_t n, double *matrix, double *right)\n{\n    size_t i, j, k;\n    int sign = 1;\n    MECHC_UNROLL\n    for (k = 0; k < n; ++k) {\n        double inverse;\n        MECHC_UNROLL\n        for (i = k + 1; i < n; ++i) {\n            if (fabs(matrix[i*n + k]) > fabs(matrix[k*n + k])) {\n                const double moved = right[k];\n                right[k] = right[i];\n                right[i] = moved;\n                MECHC_UNROLL\n                for (j = k; j < n; ++j) {\n                    const double element = matrix[k*n + j];\n                    matrix[k*n + j] = matrix[i*n + j];\n                    matrix[i*n + j] = element;\n                }\n                sign = -sign;\n            }\n        }\n        if (!(fabs(matrix[k*n + k]) > 0.0 && fabs(matrix[k*n + k]) < HUGE_VAL)) {\n            return 0;\n        }\n        sign = matrix[k*n + k] < 0.0 ? -sign : sign;\n        inverse = 1.0/matrix[k*n + k];\n        MECHC_UNROLL\n        for (j = k + 1; j < n; ++j) {\n            matrix[k*n + j] *= inverse;\n        }\n        right[k] *= inverse;\n        MECHC_UNROLL\n        for (i = k + 1; i < n; ++i) {\n            MECHC_UNROLL\n            for (j = k + 1; j < n; ++j) {\n                matrix[i*n + j] -= matrix[i*n + k]*matrix[k*n + j];\n            }\n            right[i] -= matrix[i*n + k]*right[k];\n        }\n    }\n    for (k = n; k-- > 0;) {\n        MECHC_UNROLL\n        for (j = k + 1; j < n; ++j) {\n            right[k] -= matrix[k*n + j]*right[j];\n        }\n    }\n    return sign;\n}\n']
    return "".join(_parts)


def _functions(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    for s in _known["solvers"]:
        _parts += [TEMPLATES['c/solver.jinja']({**_known, "s": s})]
    if _known["commons"]:
        _parts += [TEMPLATES['c/common.jinja'](_known)]
    for f in _known["functions"]:
        _parts += ['\n', str(f.single), '\n{\n']
        for line in f.plain.body:
            _parts += ['    ', str(line), '\n']
        if f.otherwise:
            _parts += ['    const double ', str(f.result), ' = ', str(f.plain.output), ';\n    if (', str(f.result), ' != ', str(f.result)]
            for c in f.plain.conditions:
                _parts += [' || !(', str(c), ')']
            _parts += [') {\n        return ', str(f.otherwise), ';\n    }\n    return ', str(f.result), ';\n}\n']
        else:
            if f.plain.conditions:
                _parts += ['    if (!(', str(' && '.join(map(str, f.plain.conditions))), ')) {\n        return NAN;\n    }\n']
            _parts += ['    return ', str(f.plain.output), ';\n}\n']
        if f.quick:
            _parts += ['\nstatic inline ', str(f.kernel), '\n{\n']
            for line in f.quick.body:
                _parts += ['    ', str(line), '\n']
            _parts += ['    return ', str(f.quick.output), ';\n}\n']
        _parts += ['\n', str(f.batch), '\n{\n']
        if f.quick:
            _parts += ['    size_t ', str(f.start), ', ', str(f.stop), ', ', str(f.loop), ';\n    for (', str(f.start), ' = 0; ', str(f.start), ' < ', str(f.number), '; ', str(f.start), ' = ', str(f.stop), ') {\n        ', str(f.stop), ' = ', str(f.number), ' - ', str(f.start), ' > 512 ? ', str(f.start), ' + 512 : ', str(f.number), ';\n        ', str(_known["real"].bits), ' ', str(f.missing), ' = 0;\n        for (', str(f.loop), ' = ', str(f.start), '; ', str(f.loop), ' < ', str(f.stop), '; ++', str(f.loop), ') {\n            const double ', str(f.value), ' = ', str(f.quick_call), ';\n            ', str(f.missing), ' |= mechc_nan(', str(f.value), ');\n            ', str(f.element), ' = ', str(f.value), ';\n        }\n        for (', str(f.loop), ' = ', str(f.missing), ' >> ', str(_known["real"].top), ' ? ', str(f.start), ' : ', str(f.stop), '; ', str(f.loop), ' < ', str(f.stop), '; ++', str(f.loop), ') {\n            if (', str(f.element), ' != ', str(f.element), ') {\n                ', str(f.element), ' = ', str(f.call), ';\n            }\n        }\n    }\n']
        else:
            _parts += ['    for (size_t ', str(f.loop), ' = 0; ', str(f.loop), ' < ', str(f.number), '; ++', str(f.loop), ') {\n        ', str(f.element), ' = ', str(f.call), ';\n    }\n']
        _parts += ['}\n']
        for s in [s for s in [f.status] if s]:
            _parts += [TEMPLATES['c/status.jinja']({**_known, "f": f, "s": s})]
    if _known["checks"]:
        _parts += [TEMPLATES['c/checks.jinja'](_known)]
    for pose in _known["poses"]:
        _parts += [TEMPLATES['c/pose.jinja']({**_known, "pose": pose})]
    if _known["gradients"]:
        _parts += [TEMPLATES['c/gradient.jinja'](_known)]
    if _known["parameters"]:
        _parts += [TEMPLATES['c/parameters.jinja'](_known)]
    return "".join(_parts)


def _gradient(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    for g in _known["gradients"]:
        _parts += ['\n', str(g.single), '\n{\n']
        for line in g.plain:
            _parts += ['    ', str(line), '\n']
        _parts += ['}\n']
        if g.kernel:
            _parts += ['\nstatic inline ', str(g.kernel), '\n{\n']
            for line in g.quick:
                _parts += ['    ', str(line), '\n']
            _parts += ['}\n']
        _parts += ['\n', str(g.batch), '\n{\n']
        if g.kernel:
            _parts += ['    ', str(_known["real"].bits), ' ', str(g.missing), ' = 0;\n    size_t ', str(g.loop), ';\n    for (', str(g.loop), ' = 0; ', str(g.loop), ' < ', str(g.number), '; ++', str(g.loop), ') {\n        ', str(g.quick_call), ';\n        ', str(g.missing), ' |= mechc_nan(', str(g.value), ');\n    }\n    for (', str(g.loop), ' = ', str(g.missing), ' >> ', str(_known["real"].top), ' ? 0 : ', str(g.number), '; ', str(g.loop), ' < ', str(g.number), '; ++', str(g.loop), ') {\n        if (', str(g.value), ' != ', str(g.value), ') {\n            ', str(g.call), ';\n        }\n    }\n']
        else:
            _parts += ['    for (size_t ', str(g.loop), ' = 0; ', str(g.loop), ' < ', str(g.number), '; ++', str(g.loop), ') {\n        ', str(g.call), ';\n    }\n']
        _parts += ['}\n']
    return "".join(_parts)


def _guards(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    if ('nan' in _known["helpers"]):
        _parts += ['\n/* A number whose first bit is 1 where the value is NaN: without a comparison, for vector code. */\nstatic inline ', str(_known["real"].bits), ' mechc_nan(double value)\n{\n    ', str(_known["real"].bits), ' bits;\n    memcpy(&bits, &value, sizeof bits);\n    return ', str(_known["real"].infinity), ' - (bits & ', str(_known["real"].size), ');\n}\n']
    if ('if_less' in _known["helpers"]):
        _parts += ['\n/* The value where left < right, else NaN (all bits ones): by the sign, without a branch. */\nstatic inline double mechc_if_less(double left, double right, double value)\n{\n    const double gap = left - right + 0.0; /* no zero is negative */\n    ', str(_known["real"].bits), ' sign, bits;\n    memcpy(&sign, &gap, sizeof sign);\n    memcpy(&bits, &value, sizeof bits);\n    bits |= (sign >> ', str(_known["real"].top), ') - 1u;\n    memcpy(&value, &bits, sizeof value);\n    return value + (gap - gap);\n}\n']
    if ('if_no_more' in _known["helpers"]):
        _parts += ['\n/* The value where left <= right, else NaN. */\nstatic inline double mechc_if_no_more(double left, double right, double value)\n{\n    const double gap = right - left + 0.0;\n    ', str(_known["real"].bits), ' sign, bits;\n    memcpy(&sign, &gap, sizeof sign);\n    memcpy(&bits, &value, sizeof bits);\n    bits |= 0u - (sign >> ', str(_known["real"].top), ');\n    memcpy(&value, &bits, sizeof value);\n    return value + (gap - gap);\n}\n']
    if ('if_apart' in _known["helpers"]):
        _parts += ['\n/* The value where left != right, else NaN. */\nstatic inline double mechc_if_apart(double left, double right, double value)\n{\n    return left != right ? value : NAN;\n}\n']
    return "".join(_parts)


def _header(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += [macro_remark(_known["preface"]), '#ifndef ', str(_known["guard"]), '\n#define ', str(_known["guard"]), '\n\n#include <stddef.h>\n\n', macro_restrict(), '\n#ifdef __cplusplus\nextern "C" {\n#endif\n', macro_declarations(_known["functions"], _known["parameters"]), '\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n']
    return "".join(_parts)


def _parameters(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\nconst ', str(_known["parameters"].struct), ' ', str(_known["parameters"].defaults), ' = {\n']
    for loop, field in turns(_known["parameters"].fields):
        _parts += ['    ', str(field.value), str((',' if (not loop.last) else '')), ' /* ', str(field.name), ' */\n']
    _parts += ['};\n']
    for f in _known["parameters"].functions:
        _parts += ['\n', str(f.head), '\n{\n']
        for line in f.body:
            _parts += ['    ', str(line), '\n']
        _parts += ['}\n']
    return "".join(_parts)


def _pose(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\n', str(_known["pose"].single), '\n{\n    int ', str(_known["pose"].status), ' = 0;\n']
    for line in _known["pose"].body:
        _parts += ['    ', str(line), '\n']
    for line in _known["pose"].results:
        _parts += ['    ', str(line), '\n']
    _parts += ['    if (', str(_known["pose"].missing), ') {\n        ', str(_known["pose"].status), ' = 1;\n    }\n']
    for name in _known["pose"].statuses:
        _parts += ['    ', str(_known["pose"].status), ' = ', str(name), ' > ', str(_known["pose"].status), ' ? ', str(name), ' : ', str(_known["pose"].status), ';\n']
    _parts += ['    return ', str(_known["pose"].status), ';\n}\n\n', str(_known["pose"].batch), '\n{\n    for (size_t ', str(_known["pose"].loop), ' = 0; ', str(_known["pose"].loop), ' < ', str(_known["pose"].number), '; ++', str(_known["pose"].loop), ') {\n        ', str(_known["pose"].status), '[', str(_known["pose"].loop), '] = ', str(_known["pose"].call), ';\n    }\n}\n']
    return "".join(_parts)


def _sine_double(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ["\n/*\n * sin(x + half*pi) for a half of 0.0 or 0.5, where the sine or the cosine of an angle is asked\n * for alone: the angle is reduced by half turns, and one polynomial serves. Its coefficients are\n * the best ones up to pi/2 (Remez's exchange, 2^-61); within 2.5 ulp, and NaN beyond 2^20 rad.\n */\nstatic inline double mechc_sine(double x, double half)\n{\n    const double shifter = 6755399441055744.0; /* 1.5*2^52: the sum's last bit counts half turns */\n    const double shifted = (half > 0.0 ? x*3.18309886183790671538e-01 + half : x*3.18309886183790671538e-01) + shifter;\n    const double turns = shifted - shifter - half;\n    const double beyond = x*1.71e302; /* infinite beyond 2^20, and infinity less itself is NaN */\n    const double r = x - turns*3.14159265346825122834e+00 - turns*1.21542010126079319572e-10\n        - (turns*4.04453249759190126308e-21 + (beyond - beyond));\n    const double z = r*r, zz = z*z;\n    const double s = r + z*r*(-1.66666666666666655691e-01 + z*8.33333333333319424042e-03\n        + zz*(-1.98412698412091939515e-04 + z*2.75573192111328434194e-06\n        + zz*(-2.50521068723907040075e-08 + z*1.60589396849816868426e-10\n        + zz*(-7.64299093942738370811e-13 + z*2.72116911226383240937e-15))));\n    uint64_t count, bits;\n    double result;\n    memcpy(&count, &shifted, sizeof count);\n    memcpy(&bits, &s, sizeof bits);\n    bits ^= count << 63; /* each half turn changes the sign */\n    memcpy(&result, &bits, sizeof result);\n    return result;\n}\n"]
    return "".join(_parts)


def _sine_float(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ["\n/*\n * sin(x + half*pi) for a half of 0.0 or 0.5, where the sine or the cosine of an angle is asked\n * for alone: the angle is reduced by half turns, and one polynomial serves. Its coefficients are\n * the best ones up to pi/2 (Remez's exchange, 2^-27). NaN beyond 2^13 rad.\n */\nstatic inline double mechc_sine(double x, double half)\n{\n    const double shifter = 12582912.0; /* 1.5*2^23: the sum's last bit counts half turns */\n    const double shifted = (half > 0.0 ? x*0.318309886 + half : x*0.318309886) + shifter;\n    const double turns = shifted - shifter - half;\n    const double beyond = x*4.15e34; /* infinite beyond 2^13, and infinity less itself is NaN */\n    const double r = x - turns*3.140625 - turns*9.67502593994140625e-4\n        - (turns*1.509957990978376432e-7 + (beyond - beyond));\n    const double z = r*r;\n    const double s = r + z*r*(-1.666665949e-1 + z*(8.333064644e-3\n        + z*(-1.980947751e-4 + z*2.605487704e-6)));\n    uint32_t count, bits;\n    double result;\n    memcpy(&count, &shifted, sizeof count);\n    memcpy(&bits, &s, sizeof bits);\n    bits ^= count << 31; /* each half turn changes the sign */\n    memcpy(&result, &bits, sizeof result);\n    return result;\n}\n"]
    return "".join(_parts)


def _solver(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    if _known["s"].by_arcs:
        _parts += ['\nstatic void ', str(_known["s"].by_arcs.name), '(const double *found, double aim, const double *given, double *residual, double *slope)\n{\n    const double rest = 1.0 - aim;\n']
        for line in _known["s"].by_arcs.lines:
            _parts += ['    const double ', str(line.name), ' = ', str(line.code), ';\n']
        for line in _known["s"].by_arcs.sides:
            _parts += ['    ', str(line), '\n']
        _parts += ['}\n']
    _parts += ['\n/*\n * ', str(_known["s"].title), ':\n']
    for line in _known["s"].zeros:
        _parts += [' *   ', str(line), '\n']
    _parts += [" * by Newton's method on the straight way from a solution that is known. A step is halved where\n * corrections are long or do not shrink to ", str(_known["newton"].CONTRACTION), ', or where the determinant changes its\n * sign, so that no branch is left. Returns 0, or 1 where the branch ends on the way, 2\n * where neither is found in ', str(_known["newton"].CORRECTIONS), ' corrections; the unknowns are NaN then.\n']
    if _known["s"].by_arcs:
        _parts += [' * Where steps become short the branch is followed by its arc length.\n']
    _parts += [' */\n', str(_known["s"].head), '\n{\n']
    for line in _known["s"].turned:
        _parts += ['    const double ', str(line.name), ' = ', str(line.code), '; /* the nearest of those a turn apart */\n']
    _parts += ['    double base[', str(_known["s"].size), '] = ', str(_known["s"].start), ';\n    const double far = sqrt(', str((_known["s"].far or '0.0')), ');\n    double reached = 0.0, longest = 1.0, step;\n    int count, i;\n    for (i = 0; i < ', str(_known["s"].size), '; ++i) {\n        found[i] = base[i];\n    }\n    while (longest*far > ', str(_known["newton"].WIDEST), ' && far <= ', str(_known["newton"].FARTHEST), ') {\n        longest = 0.5*longest;\n    }\n    step = longest;\n    for (count = far <= ', str(_known["newton"].FARTHEST), ' ? 0 : ', str(_known["newton"].CORRECTIONS), '; count < ', str(_known["newton"].CORRECTIONS), str(_known["s"].shortest), '; ++count) {\n        const double aim = reached + step, rest = 1.0 - aim;\n']
    for line in _known["s"].fixed:
        _parts += ['        const double ', str(line.name), ' = ', str(line.code), ';\n']
    _parts += ['        double last = 0.0;\n        int good, there;\n']
    if _known["s"].opening:
        _parts += ['        if (reached <= 0.0) { /* with the slopes of the default pose */\n            const double residual[', str(_known["s"].size), '] = {\n']
        for loop, entry in turns(_known["s"].opening.residuals):
            _parts += ['                ', str(entry), str((',' if (not loop.last) else '')), '\n']
        _parts += ['            };\n            const double change[', str(_known["s"].size), '] = {\n']
        for loop, entry in turns(_known["s"].opening.change):
            _parts += ['                ', str(entry), str((',' if (not loop.last) else '')), '\n']
        _parts += ['            };\n            last = sqrt(', str(_known["s"].norm), ');\n            if (!(last <= ', str(_known["newton"].FIRST_CORRECTION), ')) {\n                step = 0.5*step;\n                continue;\n            }\n            for (i = 0; i < ', str(_known["s"].size), '; ++i) {\n                found[i] -= change[i];\n            }\n            ++count;\n        }\n']
    _parts += ['        do {\n']
    for line in _known["s"].body:
        _parts += ['            const double ', str(line.name), ' = ', str(line.code), ';\n']
    _parts += ['            const double residual[', str(_known["s"].size), '] = {\n']
    for loop, entry in turns(_known["s"].residuals):
        _parts += ['                ', str(entry), str((',' if (not loop.last) else '')), '\n']
    _parts += ['            };\n            const double slope[', str((_known["s"].size * _known["s"].size)), '] = {\n']
    for loop, row in turns(_known["s"].jacobian):
        _parts += ['                ', str(', '.join(map(str, row))), str((',' if (not loop.last) else '')), '\n']
    _parts += ['            };\n            double right[', str(len(_known["s"].left.right)), '] = {\n']
    for loop, entry in turns(_known["s"].left.right):
        _parts += ['                ', str(entry), str((',' if (not loop.last) else '')), '\n']
    _parts += ['            };\n            double matrix[', str((len(_known["s"].left.right) * len(_known["s"].left.right))), '] = {\n']
    for loop, row in turns(_known["s"].left.matrix):
        _parts += ['                ', str(', '.join(map(str, row))), str((',' if (not loop.last) else '')), '\n']
    _parts += ['            };\n            const int sign = mechc_eliminate(', str(len(_known["s"].left.right)), ', matrix, right);\n            const double change[', str(_known["s"].size), '] = {\n']
    for loop, entry in turns(_known["s"].left.change):
        _parts += ['                ', str(entry), str((',' if (not loop.last) else '')), '\n']
    _parts += ['            };\n            const double size = sqrt(', str(_known["s"].norm), ');\n            good = sign == ', str(_known["s"].side), ' && (size <= ', str(_known["real"].tiny), ' || size <= (last > 0.0 ? ', str(_known["newton"].CONTRACTION), '*last : ', str(_known["newton"].FIRST_CORRECTION), '));\n            there = good && (size <= ', str(_known["real"].tiny), ' || size*size*size <= ', str(_known["real"].rounding), '*last*last\n                || (aim < 1.0 && size <= ', str(_known["newton"].ROUGH_CORRECTION), '));\n            for (i = 0; good && i < ', str(_known["s"].size), '; ++i) {\n                found[i] -= change[i];\n            }\n            last = size;\n        } while (good && !there && ++count < ', str(_known["newton"].CORRECTIONS), ');\n        if (there && aim >= 1.0) {\n            return 0;\n        }\n        if (there) {\n            for (i = 0; i < ', str(_known["s"].size), '; ++i) {\n                base[i] = found[i];\n            }\n            reached = aim;\n            step = 2.0*step < longest ? 2.0*step : longest;\n            step = step < rest ? step : rest;\n        } else if (!good) {\n            for (i = 0; i < ', str(_known["s"].size), '; ++i) {\n                found[i] = base[i];\n            }\n            step = 0.5*step;\n        }\n    }\n']
    if _known["s"].by_arcs:
        _parts += ['    if (far <= ', str(_known["newton"].FARTHEST), ') {\n        const double start[', str(_known["s"].size), '] = ', str(_known["s"].start), ';\n        const double given[', str(_known["s"].by_arcs.number), '] = ', str(_known["s"].by_arcs.ends), ';\n        double work[', str(_known["s"].by_arcs.room), '];\n        int status;\n        for (i = 0; i < ', str(_known["s"].size), '; ++i) {\n            found[i] = start[i];\n        }\n        status = mechc_arcs(', str(_known["s"].size), ', ', str(_known["s"].by_arcs.name), ', given, found, work);\n        if (status < 2) {\n            for (i = 0; status && i < ', str(_known["s"].size), '; ++i) {\n                found[i] = NAN;\n            }\n            return status;\n        }\n    }\n']
    _parts += ['    for (i = 0; i < ', str(_known["s"].size), '; ++i) {\n        found[i] = NAN;\n    }\n']
    if _known["s"].by_arcs:
        _parts += ['    return 2;\n']
    else:
        _parts += ['    return step < ', str(_known["newton"].SHORTEST_STEP), ' ? 1 : 2;\n']
    _parts += ['}\n']
    return "".join(_parts)


def _source(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += [macro_remark(_known["preface"])]
    if _known["header"]:
        _parts += ['#include "', str(_known["header"]), '"\n\n#include <math.h>\n']
    else:
        _parts += ['#include <math.h>\n#include <stddef.h>\n']
    if _known["bits"]:
        _parts += ['#include <stdint.h>\n#include <string.h>\n']
    _parts += ['\n#if defined(__FAST_MATH__) || defined(_M_FP_FAST) || __FINITE_MATH_ONLY__ + 0\n#ifndef MECHC_ALLOW_FAST_MATH\n#error "NaN says where there is no pose: leave out -ffast-math, or define MECHC_ALLOW_FAST_MATH"\n#endif\n#endif\n']
    if _known["roots"]:
        _parts += ['\n/* A root that leaves no trace of its failure but NaN: loops over it become vector code. */\n#ifdef __GNUC__\n#pragma GCC diagnostic push\n#pragma GCC diagnostic ignored "-Wredundant-decls"\n#ifndef __cplusplus\ndouble sqrt(double) __attribute__((const));\n#elif defined(__GLIBC__)\nextern "C" double sqrt(double) __THROW __attribute__((const));\n#endif\n#pragma GCC diagnostic pop\n#endif\n']
    if (not _known["header"]):
        _parts += ['\n', macro_restrict(), macro_declarations(_known["public"], _known["parameters"]), '\n']
    if _known["pi"]:
        _parts += ['\n#define MECHC_PI 3.14159265358979323846\n']
    for choice in _known["choices"]:
        _parts += ['\n/* Unlike f', str(choice.name), ', keeps a NaN of either side. */\nstatic inline double mechc_', str(choice.name), '(double x, double y)\n{\n    return x ', str(choice.code), ' y || x != x ? x : y;\n}\n']
    if ('sign' in _known["helpers"]):
        _parts += ['\n/* 1, -1, or what x is where it has no sign: 0 or NaN. */\nstatic inline double mechc_sign(double x)\n{\n    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : x;\n}\n']
    for condition in _known["conditions"]:
        _parts += ['\n/* 1 where it holds, 0 where it does not, NaN where a side is NaN. */\nstatic inline double mechc_', str(condition.name), '(double x, double y)\n{\n    return x != x || y != y ? NAN : x ', str(condition.code), ' y ? 1.0 : 0.0;\n}\n']
    if ('choose' in _known["helpers"]):
        _parts += ['\n/* x where the condition is 1, y where it is 0, NaN where it is NaN. */\nstatic inline double mechc_choose(double condition, double x, double y)\n{\n    return condition > 0.0 ? x : condition <= 0.0 ? y : NAN;\n}\n']
    if (('circular' in _known["helpers"]) and (_known["real"].name == 'float')):
        _parts += [TEMPLATES['c/circular_float.jinja'](_known)]
    elif ('circular' in _known["helpers"]):
        _parts += [TEMPLATES['c/circular_double.jinja'](_known)]
    if (('sine' in _known["helpers"]) and (_known["real"].name == 'float')):
        _parts += [TEMPLATES['c/sine_float.jinja'](_known)]
    elif ('sine' in _known["helpers"]):
        _parts += [TEMPLATES['c/sine_double.jinja'](_known)]
    _parts += [TEMPLATES['c/circular.jinja'](_known)]
    _parts += [TEMPLATES['c/guards.jinja'](_known)]
    if ('eliminate' in _known["helpers"]):
        _parts += ['\n']
        _parts += [TEMPLATES['c/eliminate.jinja'](_known)]
    if ('arcs' in _known["helpers"]):
        _parts += [TEMPLATES['c/arcs.jinja'](_known)]
    _parts += [str(_known["code"])]
    return "".join(_parts)


def _status(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\n', str(_known["s"].single), '\n{\n    const double value = ', str(_known["s"].value), ';\n']
    for line in _known["s"].before:
        _parts += ['    ', str(line), '\n']
    _parts += ['    const double ideal = ', str(_known["s"].ideal), ';\n    const double load = ', str(_known["s"].load), ';\n']
    if (not _known["s"].idle):
        _parts += ['    const int is_ahead = ideal >= 0.0;\n']
    _parts += ['    const int is_unloaded = fabs(ideal) < ', str(_known["s"].nothing), ' && fabs(load) < ', str(_known["s"].nothing), ';\n    if (fabs(value) < HUGE_VAL && (is_unloaded || ', str(_known["s"].moves), ')) {\n        return 0;\n    }\n    if (value != value) {\n']
    for line in _known["s"].body:
        _parts += ['        ', str(line), '\n']
    for status in _known["s"].loops:
        _parts += ['        if (', str(status), ' == 2) {\n            return 2;\n        }\n']
    _parts += ['        if (ideal != ideal']
    for condition in _known["s"].conditions:
        _parts += [' || !(', str(condition), ')']
    _parts += [') {\n            return 1;\n        }\n        if (', str(_known["s"].friction), ' == 2) {\n            return 2;\n        }\n    }\n    return ', str(('fabs(value) < HUGE_VAL' if _known["s"].idle else 'is_ahead')), ' ? ', str(_known["s"].standstill[0]), ' : ', str(_known["s"].standstill[1]), ';\n}\n\n', str(_known["s"].batch), '\n{\n    for (size_t ', str(_known["s"].loop), ' = 0; ', str(_known["s"].loop), ' < ', str(_known["s"].number), '; ++', str(_known["s"].loop), ') {\n        status[', str(_known["s"].loop), '] = ', str(_known["s"].call), ';\n    }\n}\n']
    return "".join(_parts)


TEMPLATES = {
    "c/arcs.jinja": _arcs,
    "c/checks.jinja": _checks,
    "c/circular.jinja": _circular,
    "c/circular_double.jinja": _circular_double,
    "c/circular_float.jinja": _circular_float,
    "c/common.jinja": _common,
    "c/declarations.jinja": _declarations,
    "c/eliminate.jinja": _eliminate,
    "c/functions.jinja": _functions,
    "c/gradient.jinja": _gradient,
    "c/guards.jinja": _guards,
    "c/header.jinja": _header,
    "c/parameters.jinja": _parameters,
    "c/pose.jinja": _pose,
    "c/sine_double.jinja": _sine_double,
    "c/sine_float.jinja": _sine_float,
    "c/solver.jinja": _solver,
    "c/source.jinja": _source,
    "c/status.jinja": _status,
}
