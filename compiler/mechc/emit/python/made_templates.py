"""The templates of this folder as functions, made by ``mechc.emit.make_templates``."""

from collections.abc import Mapping
from typing import Any

from ..render import turns


def _arcs(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\n\ndef _along_arcs(sides, start):\n    """Return status and unknowns by the arc length of the branch, past places where it is steep.\n\n    Status 0: at the end of the way; 1: it turns back before, at a fold between two points; 2: neither\n    is found in so many points.\n    """\n    size, poses = start.shape\n    status, result = np.full(poses, 2), np.full((size, poses), np.nan)\n    along = np.zeros((size + 1, 1))\n    along[-1] = 1.0\n\n    def dot(one, other):\n        return np.sum(one*other, axis=0)\n\n    def bordered(poses, points, across):\n        unknowns, share = points[:-1], points[-1]\n        residuals, rows = sides(poses, unknowns, share)\n        right = np.concatenate([residuals, np.zeros((1, len(share)))])\n        return np.concatenate([rows, np.broadcast_to(across, points.shape)[None]]), right\n\n    def tangent(poses, points, before):\n        matrix, right = bordered(poses, points, before)\n        right = np.zeros_like(right)\n        right[-1] = 1.0\n        sign = _eliminate(matrix, right)\n        return sign, right/np.sqrt(dot(right, right))\n\n    def corrected(poses, found, across, most, side):\n        tiny = np.maximum(', str(_known["arcs"].TINY), ', np.where(side == 0, ', str(_known["arcs"].EXACT_ON_THE_WAY), '*most, 0.0))\n        good, there = np.ones(len(poses), bool), np.zeros(len(poses), bool)\n        for _ in range(', str(_known["arcs"].POINT_CORRECTIONS), '):\n            matrix, change = bordered(poses, found, across)\n            sign = _eliminate(matrix, change)\n            size = np.sqrt(dot(change, change))\n            good = good & (there | ((sign != 0) & ((size <= ', str(_known["arcs"].TINY), ') | (size <= most))))\n            found = np.where(good & ~there, found - change, found)\n            last = most/', str(_known["arcs"].CONTRACTION), '\n            ends = good & ~there & ((size <= tiny) | (size*size*size <= ', str(_known["arcs"].ROUNDING), '*last*last))\n            good = good & (~ends | (side == 0) | (sign == side))\n            there, most = there | ends, ', str(_known["arcs"].CONTRACTION), '*size\n            if np.all(there | ~good):\n                break\n        return good & there, found\n\n    def straight(poses):\n        found = np.concatenate([start[:, poses], np.ones((1, len(poses)))])\n        good, there = np.ones(len(poses), bool), np.zeros(len(poses), bool)\n        for _ in range(', str(_known["arcs"].FOLD_CORRECTIONS), '):\n            matrix, change = bordered(poses, found, along)\n            sign = _eliminate(matrix, change)\n            good = good & (there | (sign != 0))\n            found = np.where(good & ~there, found - change, found)\n            there = there | (good & (np.sqrt(dot(change, change)) <= ', str(_known["arcs"].TINY), '))\n        return good & there & (found[-2] > 0.0), found\n\n    left = np.arange(poses)\n    points = np.concatenate([start, np.zeros((1, poses))])\n    side, tangents = tangent(left, points, along)\n    on = side != 0\n    left, points, tangents, side = left[on], points[:, on], tangents[:, on], side[on]\n    arc = np.full(len(left), ', str(_known["arcs"].FIRST), ')\n    for _ in range(', str(_known["arcs"].MOST_POINTS), '):\n        if not len(left):\n            break\n        rest = (1.0 - points[-1])/tangents[-1]\n        final = arc >= rest\n        length = np.where(final, rest, arc)\n        ahead = points + length*tangents\n        ahead[-1] = np.where(final, 1.0, ahead[-1])\n        across, asked = np.where(final, along, tangents), np.where(final, side, 0)\n        there, found = corrected(left, ahead, across, ', str(_known["arcs"].FIRST_CORRECTION_OF_ARC), '*length, asked)\n        here, turned = tangent(left, found, tangents)\n        end = there & final\n        cosine = dot(turned, tangents)\n        rises, alike = turned[-1] > 0.0, here == side\n        close = np.where(rises, ', str(_known["arcs"].STRAIGHT_COSINE), ', ', str(_known["arcs"].FOLDED), ')\n        bent = np.where(alike & (rises | (length <= ', str(_known["arcs"].SHARP), ')), ', str(_known["arcs"].ARC_COSINE), ', close)\n        good = there & (found[-1] <= 1.0) & (here != 0) & (rises | alike) & (cosine >= bent)\n        longer = np.where(cosine >= ', str(_known["arcs"].EASY), ', np.minimum(2.0*arc, ', str(_known["arcs"].LONGEST), '), arc)\n        fold = good & ~end & (turned[-1] <= 0.0)\n        status[left[end]], result[:, left[end]] = 0, found[:-1, end]\n        status[left[fold]] = 1\n        if np.any(fold):  # made by what is rounded off if a solution is found from the start\n            solved, whole = straight(left[fold])\n            status[left[fold][solved]], result[:, left[fold][solved]] = 0, whole[:-1, solved]\n        points, tangents = np.where(good, found, points), np.where(good, turned, tangents)\n        side = np.where(good, here, side)\n        arc = np.where(good, longer, length/2.0)\n        on = ~end & ~fold & (arc >= ', str(_known["arcs"].LEAST), ')\n        left, points, tangents = left[on], points[:, on], tangents[:, on]\n        arc, side = arc[on], side[on]\n    return status, result\n']
    return "".join(_parts)


def _checks(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\n\ndef ', str(_known["checks"].name), '(', str(', '.join(map(str, _known["checks"].arguments))), '):\n    """Return 0 where all conditions hold, else the number of the first that does not.\n\n']
    for line in _known["checks"].meanings:
        _parts += ['        ', str(line), '\n']
    _parts += ['\n    Args:\n']
    for item in _known["checks"].inputs:
        _parts += ['        ', str(item.name), ': ', str(item.code), '\n']
    _parts += ['    """\n']
    for argument in _known["checks"].arguments:
        _parts += ['    ', str(argument), ' = np.asarray(', str(argument), ', dtype=float)\n']
    _parts += ['    with np.errstate(all="ignore"):\n']
    for line in _known["checks"].body:
        _parts += ['        ', str(line.name), ' = ', str(line.code), '\n']
    _parts += ['        status = 0\n']
    for loop, condition in turns(reversed(_known["checks"].conditions)):
        _parts += ['        status = np.where(', str(condition), ', status, ', str(loop.revindex), ')\n']
    _parts += ['    return status if np.ndim(status) else int(status)\n']
    return "".join(_parts)


def _common(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    for c in _known["commons"]:
        _parts += ['\n\ndef ', str(c.name), '(', str(', '.join(map(str, c.arguments))), '):\n    """Return the quantities common to many of the functions below, by name."""\n']
        for line in c.body:
            _parts += ['    ', str(line.name), ' = ', str(line.code), '\n']
        _parts += ['    return {\n']
        for line in c.outputs:
            _parts += ['        ', str(line.name), ': ', str(line.code), ',\n']
        _parts += ['    }\n']
    return "".join(_parts)


def _gradient(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    for g in _known["gradients"]:
        _parts += ['\n\ndef ', str(g.name), '(', str(', '.join(map(str, g.arguments))), '):\n    """Return the ', str(g.title), ' and its slopes by each argument, by name.\n\n    ', str(g.outputs[0].name), ' is the value; the slopes are\n']
        for line in g.outputs[1:]:
            _parts += ['        ', str(line.name), '\n']
        if g.remarks:
            _parts += ['\n']
            for line in g.remarks:
                _parts += ['    ', str(line), '\n']
        _parts += ['\n    Args:\n']
        for item in g.inputs:
            _parts += ['        ', str(item.name), ': ', str(item.code), '\n']
        _parts += ['\n    Operations: ', str(g.operations), '\n    """\n']
        for argument in g.arguments:
            _parts += ['    ', str(argument), ' = np.asarray(', str(argument), ', dtype=float)\n']
        _parts += ['    with np.errstate(all="ignore"):\n']
        for line in g.body:
            _parts += ['        ', str(line.name), ' = ', str(line.code), '\n']
        _parts += ['    found = {\n']
        for line in g.outputs:
            _parts += ['        ', str(line.name), ': ', str(line.code), ',\n']
        _parts += ['    }\n    return {name: value if np.ndim(value) else float(value) for name, value in found.items()}\n']
    return "".join(_parts)


def _module(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['"""', str(_known["heading"]), '.\n\n']
    for line in _known["preface"]:
        _parts += [str(line), '\n']
    _parts += ['"""\n\nimport numpy as np\n']
    if _known["defaults"]:
        _parts += ['\nDEFAULTS = {\n']
        for item in _known["defaults"]:
            _parts += ['    "', str(item.name), '": ', str(item.code), ',\n']
        _parts += ['}\n"""The values of the description, by argument, in SI and radians."""\n']
    if _known["ranges"]:
        _parts += ['\nRANGES = {\n']
        for item in _known["ranges"]:
            _parts += ['    "', str(item.name), '": ', str(item.code), ',\n']
        _parts += ['}\n"""The ranges of the description, from and to, in SI and radians."""\n']
    if _known["solvers"]:
        _parts += [TEMPLATES['python/newton.jinja'](_known)]
    for condition in _known["conditions"]:
        _parts += ['\n\ndef _', str(condition.name), '(left, right):\n    """Return 1 where it holds, 0 where it does not, NaN where a side is NaN."""\n    return np.where(np.isnan(left) | np.isnan(right), np.nan, left ', str(condition.code), ' right)\n']
    if _known["chooses"]:
        _parts += ['\n\ndef _choose(condition, value, other):\n    """Return the value where the condition is 1, the other where it is 0, else NaN."""\n    return np.where(condition > 0, value, np.where(condition <= 0, other, np.nan))\n']
    if _known["commons"]:
        _parts += [TEMPLATES['python/common.jinja'](_known)]
    for f in _known["functions"]:
        _parts += ['\n\ndef ', str(f.name), '(', str(', '.join(map(str, f.arguments))), '):\n    """Return the ', str(f.title), str(f.unit), '.\n\n']
        for line in f.formulas:
            _parts += ['        ', str(line), '\n']
        if f.conditions:
            _parts += ['\n    NaN unless\n']
            for line in f.conditions:
                _parts += ['        ', str(line), '\n']
        if f.remarks:
            _parts += ['\n']
            for line in f.remarks:
                _parts += ['    ', str(line), '\n']
        if f.inputs:
            _parts += ['\n    Args:\n']
            for item in f.inputs:
                _parts += ['        ', str(item.name), ': ', str(item.code), '\n']
        _parts += ['\n    Operations: ', str(f.operations), '\n    """\n    return _in_blocks(', str(', '.join(map(str, ([f.block] + f.arguments)))), ')\n\n\ndef ', str(f.block), '(', str(', '.join(map(str, f.arguments))), '):\n']
        for line in f.body:
            _parts += ['    ', str(line.name), ' = ', str(line.code), '\n']
        if f.otherwise:
            _parts += ['    if np.any(np.isnan(', str(f.result), ')):\n        ', str(f.result), ' = np.where(np.isnan(', str(f.result), '), ', str(f.otherwise), ', ', str(f.result), ')\n']
        _parts += ['    return ', str(f.result), '\n']
        for s in [s for s in [f.status] if s]:
            _parts += [TEMPLATES['python/status.jinja']({**_known, "f": f, "s": s})]
    if _known["poses"]:
        _parts += [TEMPLATES['python/pose.jinja'](_known)]
    if _known["checks"]:
        _parts += [TEMPLATES['python/checks.jinja'](_known)]
    if _known["gradients"]:
        _parts += [TEMPLATES['python/gradient.jinja'](_known)]
    if _known["pairs"]:
        _parts += ['\n\ndef _cos_sin(angle):\n    """Return cosine and sine: of many angles by tangents, where NumPy has these as vector code.\n\n    tan x gives the size of the cosine, tan x/2 has the sign of the sine; within 4 ulp.\n    """\n    if np.size(angle) < 512 or not _VECTOR_TANGENTS:\n        return np.cos(angle), np.sin(angle)\n    tangent, half = np.tan(angle), np.tan(0.5*angle)\n    cosine = 1.0/np.sqrt(1.0 + tangent*tangent)\n    return np.copysign(cosine, tangent*half), np.copysign(tangent*cosine, half)\n\n\ndef _has_vector_tangents():\n    try:\n        from numpy.lib.introspect import opt_func_info\n    except ImportError:  # before NumPy 2\n        return False\n    found = opt_func_info("^tan$", "float64").get("tan", {}).get("dd", {})\n    return not found.get("current", "baseline").startswith("baseline")\n\n\n_VECTOR_TANGENTS = _has_vector_tangents()\n']
    if _known["functions"]:
        _parts += ['\n\ndef _in_blocks(function, *arguments):\n    """Return a function\'s values: of many poses a block at a time, so that it fits the cache."""\n    arguments = [np.asarray(each, dtype=float)[()] for each in arguments]\n    wide = [i for i, each in enumerate(arguments) if each.ndim]\n    many = wide and np.prod(np.broadcast_shapes(*(arguments[i].shape for i in wide))) > 8192\n    with np.errstate(all="ignore"):\n        if not many or len(wide) > 30:\n            result = function(*arguments)\n            return result if np.ndim(result) else float(result)\n        blocks = np.nditer(\n            [*(arguments[i] for i in wide), None],\n            ["external_loop", "buffered"],\n            [["readonly"]]*len(wide) + [["writeonly", "allocate"]],\n            buffersize=8192,\n        )\n        with blocks:\n            for *given, result in blocks:\n                for i, each in zip(wide, given):\n                    arguments[i] = each\n                result[...] = function(*arguments)\n            return blocks.operands[-1]\n']
    if _known["main"]:
        _parts += ['\n\nif __name__ == "__main__":\n']
        for line in _known["main"]:
            _parts += ['    ', str(line), '\n']
    return "".join(_parts)


def _newton(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\n\ndef _eliminate(matrix, right):\n    """Solve matrix · x = right in place for every pose; return the determinants\' signs."""\n    size, poses = len(right), np.arange(right.shape[1])\n    sign = np.ones(len(poses))\n    for k in range(size):\n        best = k + np.argmax(np.abs(matrix[k:, k]), axis=0)\n        for array in (matrix, right):\n            upper, lower = array[k].copy(), array[best, ..., poses]\n            array[k] = np.moveaxis(lower, 0, -1)\n            array[best, ..., poses] = np.moveaxis(upper, -1, 0)\n        pivot = matrix[k, k]\n        sign = np.where(best != k, -sign, sign)*np.where(np.isfinite(pivot), np.sign(pivot), 0.0)\n        for i in range(k + 1, size):\n            times = matrix[i, k]/pivot\n            matrix[i, k + 1:] -= times*matrix[k, k + 1:]\n            right[i] -= times*right[k]\n    for k in reversed(range(size)):\n        for j in range(k + 1, size):\n            right[k] -= matrix[k, j]*right[j]\n        right[k] /= matrix[k, k]\n    return sign\n\n\ndef _stacked(rows, shape):\n    return np.stack([np.broadcast_to(np.asarray(row, dtype=float), shape) for row in rows])\n']
    if _known["by_arcs"]:
        _parts += [TEMPLATES['python/arcs.jinja'](_known)]
    _parts += ['\n\ndef _follow(equations, start, anchor, side, scales, outer', str((', by_arcs' if _known["by_arcs"] else '')), '):\n    """Return status and unknowns: Newton\'s method on the straight way from a known solution.\n\n    A step is halved where corrections are long or do not shrink to ', str(_known["newton"].CONTRACTION), ', or where the\n    determinant changes its sign, so that no branch is left. Status 0: solved; 1: the\n    branch ends on the way; 2: neither is found in so many corrections. Unknowns are NaN then.\n']
    if _known["by_arcs"]:
        _parts += ['    With ``by_arcs`` the branch is followed by its arc length where steps become short.\n']
    _parts += ['    """\n    shape = np.broadcast_shapes(*(np.shape(value) for value in outer))\n    size = int(np.prod(shape))\n\n    def wide(values):\n        return _stacked(values, shape).reshape(len(values), size)\n\n    start, anchor, outer = wide(start), wide(anchor), wide(outer)\n    scales = np.array(scales)[:, None]\n\n    def corrections(unknowns, known):\n        residuals, *rows = equations(unknowns, known)\n        right = _stacked(residuals, unknowns[0].shape)\n        matrix = np.stack([_stacked(row, unknowns[0].shape) for row in rows])\n        return _eliminate(matrix, right), right\n\n    poses = outer.shape[1]\n    status, result = np.full(poses, 2), np.full((len(start), poses), np.nan)\n    parts = (outer - anchor)/np.maximum(1.0, np.abs(anchor)/np.pi)\n    far = np.sqrt(np.sum(parts*parts, axis=0))\n    longest = np.where(far <= ', str(_known["newton"].FARTHEST), ', 1.0, 0.0)\n    while np.any(wide := longest*far > ', str(_known["newton"].WIDEST), '):\n        longest = np.where(wide, longest/2, longest)\n    left = np.flatnonzero(longest)\n    base, longest = start[:, left], longest[left]\n    found, step = base.copy(), longest\n    reached, last = np.zeros(len(left)), np.zeros(len(left))\n']
    if _known["by_arcs"]:
        _parts += ['    tried = left\n']
    _parts += ['    for _ in range(', str(_known["newton"].CORRECTIONS), '):\n']
    if _known["by_arcs"]:
        _parts += ['        if by_arcs:\n            on = step >= ', str(_known["newton"].ARCS_FROM), '\n            left, base, found = left[on], base[:, on], found[:, on]\n            reached, step, last, longest = reached[on], step[on], last[on], longest[on]\n']
    _parts += ['        if not len(left):\n            break\n        aim = reached + step\n        sign, change = corrections(found, (1.0 - aim)*anchor[:, left] + aim*outer[:, left])\n        size = np.sqrt(np.sum(change/scales*(change/scales), axis=0))\n        allowed = np.where(last > 0, ', str(_known["newton"].CONTRACTION), '*last, ', str(_known["newton"].FIRST_CORRECTION), ')\n        good = (sign == side) & (sign != 0) & ((size <= ', str(_known["newton"].TINY), ') | (size <= allowed))\n        found = np.where(good, found - change, base)\n        precise = (size <= ', str(_known["newton"].TINY), ') | (size*size*size <= ', str(_known["newton"].NEGLIGIBLE_CORRECTION), '*last*last)\n        there = good & (precise | ((aim < 1.0) & (size <= ', str(_known["newton"].ROUGH_CORRECTION), ')))\n        last = np.where(good & ~there, size, 0.0)\n        base = np.where(there, found, base)\n        reached = np.where(there, aim, reached)\n        ahead = np.minimum(np.minimum(2*step, longest), 1.0 - reached)\n        step = np.where(there, ahead, np.where(good, step, step/2))\n        solved = there & (aim == 1.0)\n        status[left[solved]], result[:, left[solved]] = 0, found[:, solved]\n        on = ~solved\n        left, base, found = left[on], base[:, on], found[:, on]\n        reached, step, last, longest = reached[on], step[on], last[on], longest[on]\n']
    if _known["by_arcs"]:
        _parts += ['    if by_arcs:\n        left = tried[status[tried] > 0]\n\n        def sides(poses, unknowns, share):\n            begin, end = anchor[:, left[poses]], outer[:, left[poses]]\n            known = (1.0 - share)*begin + share*end\n            residuals, *rows, by_share = equations(unknowns, known, end - begin)\n            rows = [(*row, last) for row, last in zip(rows, by_share)]\n            matrix = np.stack([_stacked(row, share.shape) for row in rows])\n            return _stacked(residuals, share.shape), matrix\n\n        status[left], result[:, left] = _along_arcs(sides, start[:, left])\n        return status.reshape(shape), result.reshape(len(start), *shape)\n']
    _parts += ['    status[left] = np.where(step < ', str(_known["newton"].SHORTEST_STEP), ', 1, 2)\n    return status.reshape(shape), result.reshape(len(start), *shape)\n']
    if _known["turning"]:
        _parts += ['\n\ndef _nearest(angle, anchor):\n    """Return an angle that is known but for whole turns where it is nearest to another one."""\n    return angle - 2.0*np.pi*np.floor((angle - anchor)/(2.0*np.pi) + 0.5)\n']
    for s in _known["solvers"]:
        _parts += ['\n\ndef ', str(s.name), '(', str(', '.join(map(str, s.outer))), '):\n    """Return the status and ', str(', '.join(map(str, s.unknowns))), ', for which these are zero:\n\n']
        for line in s.zeros:
            _parts += ['        ', str(line), '\n']
        _parts += ['    """\n    def equations(unknowns, outer', str((', changes=None' if s.by_arcs else '')), '):\n        ', str(', '.join(map(str, s.unknowns))), str((',' if (len(s.unknowns) == 1) else '')), ' = unknowns\n        ', str(', '.join(map(str, s.outer))), str((',' if (len(s.outer) == 1) else '')), ' = outer\n']
        for line in s.body:
            _parts += ['        ', str(line.name), ' = ', str(line.code), '\n']
        _parts += ['        ', str(('rows =' if s.by_arcs else 'return')), ' (\n']
        for row in s.rows:
            _parts += ['            (', str(', '.join(map(str, row))), str((',' if (len(row) == 1) else '')), '),\n']
        _parts += ['        )\n']
        if s.by_arcs:
            _parts += ['        if changes is None:\n            return rows\n']
            for line in s.changes:
                _parts += ['        ', str(line.name), ' = ', str(line.code), '\n']
            _parts += ['        return (*rows, (', str(', '.join(map(str, s.by_share))), str((',' if (len(s.by_share) == 1) else '')), '))\n']
        _parts += ['\n    start = (', str(', '.join(map(str, s.start))), ',)\n    anchor = (', str(', '.join(map(str, s.anchor))), ',)\n    scales = (', str(', '.join(map(str, s.scales))), ',)\n']
        for line in s.turned:
            _parts += ['    ', str(line.name), ' = ', str(line.code), '\n']
        _parts += ['    return _follow(equations, start, anchor, ', str(s.side), ', scales, (', str(', '.join(map(str, s.outer))), ',)']
        if _known["by_arcs"]:
            _parts += [', ', str(s.by_arcs)]
        _parts += [')\n']
    return "".join(_parts)


def _pose(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    for pose in _known["poses"]:
        _parts += ['\n\ndef ', str(pose.name), '(', str(', '.join(map(str, pose.arguments))), '):\n    """Return the ', str(pose.title), ' by their names, and the status.\n\n    Status 0: ', str(('there is a pose' if pose.closed else 'all are there')), '; 1: the loops do not close, or a branch has ended on the way\n    from the default pose']
        if pose.statuses:
            _parts += ['; 2: no convergence']
        _parts += ['. What is not there is NaN.\n']
        if pose.meanings:
            _parts += ['\n']
            for line in pose.meanings:
                _parts += ['    ', str(line), '\n']
        _parts += ['\n    Args:\n']
        for item in pose.inputs:
            _parts += ['        ', str(item.name), ': ', str(item.code), '\n']
        _parts += ['    """\n']
        for argument in pose.arguments:
            _parts += ['    ', str(argument), ' = np.asarray(', str(argument), ', dtype=float)\n']
        _parts += ['    with np.errstate(all="ignore"):\n']
        for line in pose.body:
            _parts += ['        ', str(line.name), ' = ', str(line.code), '\n']
        _parts += ['    found = {\n']
        for line in pose.outputs:
            _parts += ['        ', str(line.name), ': ', str(line.code), ',\n']
        _parts += ['    }\n    status = 0\n']
        if pose.closed:
            _parts += ['    closed = (', str(', '.join(map(str, pose.closed))), ',)\n']
        _parts += ['    for each in [']
        for s in pose.statuses:
            _parts += [str(s), ', ']
        _parts += ['*map(np.isnan, ', str(('map(found.get, closed)' if pose.closed else 'found.values()')), ')]:\n        status = np.maximum(status, each)\n    found = {name: value if np.ndim(value) else float(value) for name, value in found.items()}\n    return found, status if np.ndim(status) else int(status)\n']
    return "".join(_parts)


def _status(_known: Mapping[str, Any]) -> str:
    _parts: list[str] = []
    _parts += ['\n\ndef ', str(_known["s"].name), '(', str(', '.join(map(str, _known["s"].arguments))), '):\n    """Return the status of ', str(_known["s"].of), ', which tells its numbers and NaN apart:\n\n']
    for line in _known["s"].meanings:
        _parts += ['        ', str(line), '\n']
    if _known["s"].inputs:
        _parts += ['\n    Args:\n']
        for item in _known["s"].inputs:
            _parts += ['        ', str(item.name), ': ', str(item.code), '\n']
    _parts += ['    """\n']
    for argument in _known["s"].arguments:
        _parts += ['    ', str(argument), ' = np.asarray(', str(argument), ', dtype=float)\n']
    _parts += ['    value = ', str(_known["s"].value), '\n    with np.errstate(all="ignore"):\n']
    for line in _known["s"].body:
        _parts += ['        ', str(line.name), ' = ', str(line.code), '\n']
    _parts += ['        ideal, load = ', str(_known["s"].ideal), ', ', str(_known["s"].load), '\n        ahead = ', str(('np.isfinite(value)' if _known["s"].idle else 'np.greater_equal(ideal, 0.0)')), '\n        unloaded = (np.abs(ideal) < ', str(_known["s"].nothing), ') & (np.abs(load) < ', str(_known["s"].nothing), ')\n        found = np.where(ahead, ', str(_known["s"].standstill[0]), ', ', str(_known["s"].standstill[1]), ')\n        found = np.where(np.isnan(value) & np.equal(', str(_known["s"].friction), ', 2), 2, found)\n        found = np.where(np.isnan(value) & np.isnan(ideal), 1, found)\n']
    for condition in _known["s"].conditions:
        _parts += ['        found = np.where(np.isnan(value) & ~(', str(condition), '), 1, found)\n']
    for status in _known["s"].loops:
        _parts += ['        found = np.where(np.isnan(value) & np.equal(', str(status), ', 2), 2, found)\n']
    _parts += ['        moves = unloaded | (', str(_known["s"].moves), ')\n        found = np.where(np.isfinite(value) & moves, 0, found)\n    return found if np.ndim(found) else int(found)\n']
    return "".join(_parts)


TEMPLATES = {
    "python/arcs.jinja": _arcs,
    "python/checks.jinja": _checks,
    "python/common.jinja": _common,
    "python/gradient.jinja": _gradient,
    "python/module.jinja": _module,
    "python/newton.jinja": _newton,
    "python/pose.jinja": _pose,
    "python/status.jinja": _status,
}
