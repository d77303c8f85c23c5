"""What reports say in English, and with the files beside this one all words of the language."""

from ..locale import Locale
from . import along_stroke, checked, forces_and_friction, pictured

LOCALE = Locale(
    babel="english",
    functions={"tan": r"\tan", "cot": r"\cot", "atan": r"\arctan"},
    decimal=".",
    cyrillic=False,
    subjects={
        "force ratio": "Force transmission of the mechanism",
        "speed ratio": "Speeds of the mechanism",
        "forces": "Forces in equilibrium",
    },
    source="Source",
    made_by="Derived by mechc {version}",
    given="Given",
    conventions="Directions are angles counter-clockwise from the {x} axis.",
    plain_numbers="Numbers without a unit inside formulas are in units of the SI.",
    atan2="{function} is the direction of the vector with the components {x} and {y}.",
    symbol="Symbol",
    quantity="Quantity",
    value="Value",
    range="Range",
    any_value="any",
    driving="driving coordinate",
    pivots="pinned to the ground: {points}",
    directions={
        "absolute": "{angle}",
        "relative": "of {angle}",
        "turned": "of {angle} turned by $+90^\\circ$",
    },
    slider="the point {point} moves along a guide with the direction {direction}",
    through=", through {point}",
    rods="{forms:link|links} with two pins: {links}",
    bodies="rigid {forms:link|links}: {links}",
    force="the force {load} acts at {point} in the direction {direction}",
    weight="the weight {load} acts at {point} in the direction {direction}",
    torque="the couple {load} acts on the link {link}, positive counter-clockwise",
    mirror="the mechanism is symmetric about a line with the direction {direction}; "
    "one half is described, both halves share {points}",
    copies="the mechanism has {number} identical branches that share {points}",
    joints={
        "part": "{part} is the mechanism {name}; its {forms:point|points} {there} {forms:is|are} "
        "{here} here",
        "driven": "the drive is {parameter}, from {low} to {high}",
        "slide": "the body {body} only translates, in the direction {direction}",
        "telescope": "telescopic {forms:link|links}: {links}",
        "slot": "the pin {point} slides along the line {line} of {body}",
        "slot of two": "the pin {point} slides along {body}",
        "guided": "the link {guided} is fast in the block at {point} and turns with {body}",
        "arc": "the pin {point} slides in a circular slot of {body} about {centre}, of radius "
        "{radius}",
        "spread": "the load {load} is spread over {stretch} in the direction {direction}; its "
        "resultant acts at {point}, {reach}",
        "contact": "the point {point} touches {body}; the common normal has the direction {normal}",
        "gear": "the gears on {first} (radius {one}) and {second} (radius {two}) mesh",
        "inner": "the gears on {first} (radius {one}) and {second} (radius {two}) mesh, one "
        "inside the other",
        "belt": "a belt joins the pulleys on {first} (radius {one}) and {second} (radius {two})",
        "crossed": "a crossed belt joins the pulleys on {first} (radius {one}) and "
        "{second} (radius {two})",
        "wheel": "the wheel{radius} on {point} is fixed to {link}",
        "fixed wheel": "the wheel{radius} on {point} is fixed to the ground",
        "of radius": " of radius",
        "arm": "the link {link} carries the centres of the wheels on {points}",
        "rack": "the rack at {point} meshes with the gear on {pivot} (radius {radius})",
        "rack on the left": "the rack at {point} meshes with the gear on {pivot} (radius {radius}"
        "); along its guide the rack is on the left of {pivot}",
        "screw": "the screw {link} moves {point} by {pitch} for each turn",
        "rope": "a rope runs through {points}, over a pulley at each point between its ends",
        "flexible": "a rope, band or belt runs through {points}, around a pulley or drum at each "
        "point between its ends",
        "on link": "{point} on the link {link}",
        "actuator": "the actuator {load} pushes {first} and {second} apart",
        "spring": "the spring {load} acts between {first} and {second}",
        "drive": "the drive is {name}",
    },
    given_friction={
        "pin": "friction in the pin {points}: the radius of its friction circle is {value}",
        "pins": "friction in the pins {points}: the radius of their friction circles is {value}",
        "guide": "friction in the guide of {point}: coefficient {value}",
        "reduced guide": "friction in the guide of {point}: reduced coefficient {value}",
        "face": "friction where {point} slides on another body: coefficient {value}",
        "gear": "friction of the gears that {point} is the first centre of: a fraction {value} of "
        "the transmitted force is lost",
        "belt": "friction of the belt that {point} is the first centre of: a fraction {value} of "
        "the transmitted force is lost",
        "rack": "friction of the rack at {point}: a fraction {value} of the transmitted force is "
        "lost",
        "screw": "friction in the thread of the screw at {point}: coefficient {value}, mean "
        "diameter {diameter}",
        "collar": "friction at the collar of the screw at {point}: coefficient {value}, mean "
        "radius {radius}",
        "pivot collar": "friction at the collar on {point}: coefficient {value} (of all faces "
        "together), mean radius {radius}, thrust {thrust}",
        "rope": "friction of the rope or band around {point}: coefficient {value}, angle of wrap "
        "{wrap}",
        "efficiency": "the efficiency is {value}",
        "tightening": "with friction the motion is along the arrow of {loads}",
        "releasing": "with friction the motion is against the arrow of {loads}",
    },
    roles={
        "coordinate": "coordinate of {point}",
        "guide": "coordinate of the guide of {point}",
        "angle": "angle {point}",
        "radius": "radius of the wheel on {point}",
        "pulley": "radius of the pulley on {point}",
        "pitch": "pitch of the screw at {point}",
        "loss": "part of the force that is lost",
        "coefficient": "coefficient of friction",
        "pin": "diameter of the pin",
        "pins": "diameter of the pins",
        "wrap": "angle of wrap",
        "thread": "mean diameter of the thread",
        "collar": "mean diameter of the collar",
        "rate": "rate of the spring",
        "rates": "rate of the springs",
        "free length": "free length of the spring",
        "free lengths": "free length of the springs",
        "force": "force",
        "couple": "couple",
        "mass": "mass",
        "intensity": "intensity",
        "x coordinate": "horizontal coordinate of {point}",
        "y coordinate": "vertical coordinate of {point}",
        "x component": "horizontal component of the vector {point}",
        "y component": "vertical component of the vector {point}",
    },
    geometry="Geometry",
    vector="Vector",
    length="Length or coordinates",
    direction="Direction",
    position="Position",
    loops={
        "triangle": "Triangle {loop}, its vertices in {turn} order: its three sides are known, "
        "the law of cosines gives its angles.",
        "guide": "Loop {loop}: its projections across the guide and along it give a direction and"
        " the place on the guide.",
        "inclination": "Loop {loop}: its projection across the guide gives the direction of the "
        "link.",
        "radius": "Loop {loop}: its projection across the guide gives the direction of the radius "
        "of the circular slot.",
        "radius and place": "Loop {loop}: its projections across the guide and along it give the "
        "direction of the radius of the circular slot and the place on the guide.",
        "slot": "Loop {loop}: its projections across the line of the slot and along it give the "
        "direction of that line and the place on it.",
        "aligned": "Loop {loop}: the slot has the direction of the vector {part}, whose length is "
        "the distance along it.",
        "cylinder": "The cylinder {part}: the places of its ends give {found}.",
        "telescope": "The telescopic link {part}: the places of its ends give {found}.",
        "equal": "Loop {loop}: lengths in it are equal, so that its directions follow at once.",
        "isosceles": "Triangle {loop} is isosceles, {sides}: its directions follow at once.",
        "parallelogram": "Opposite sides of {loop} are equal: it is a parallelogram, so that they "
        "are parallel.",
        "rhombus": "All sides of {loop} are equal: it is a rhombus, so that opposite sides are "
        "parallel.",
        "mirrored": "Loop {loop}: its unknown sides are as long as the known ones, so that they "
        "have the directions of these, mirrored in the line {side}.",
        "congruent": "Triangles {loop} and {like} are congruent by their three sides: their angles "
        "at {pins} are equal.",
        "lengths": "Loop {loop}: its projections give two lengths.",
        "length": "Loop {loop}: its projection gives a length.",
        "sum": "The vector {loop} is a sum of vectors: its projections give {found}.",
        "angle": "The angle {loop} of a link from what is given.",
        "vector": "The vector between points of {loop} that have their places.",
        "system": "The loops through {all} close together; their equations are solved by "
        "iteration.",
    },
    introduced={
        "corners": "Here {corners}.",
        "both": "its direction and length",
        "bearing": "its direction",
        "length": "its length",
        "inclination": "{symbol} is the inclination of {part} to the guide.",
        "direction": "{symbol} is the direction of the vector {vector}, counter-clockwise from "
        "{x}.",
        "directions": "{symbol} is the direction of the vector {vector}, counter-clockwise from "
        "{x}; those of other vectors are named likewise.",
        "ahead": "Of the two possible places of {pin} on the guide it is the one farther in "
        "the direction of the guide.",
        "behind": "Of the two possible places of {pin} on the guide it is the one farther "
        "against the direction of the guide.",
    },
    loops_again={
        "triangle": "Likewise triangle {loop}, its vertices in {turn} order.",
        "guide": "Likewise loop {loop}, across its guide and along it.",
        "inclination": "Likewise loop {loop}, across its guide.",
        "slot": "Likewise loop {loop}, across the line of its slot and along it.",
    },
    turns={"cw": "clockwise", "ccw": "counter-clockwise"},
    velocities="Velocities",
    magnitudes="Each velocity is counted positive in the sense in which its point or link moves at "
    "the values given, its component along a load in the direction of this load; a minus sign "
    "means the opposite sense.",
    signed="Velocities along guides are positive in the guide's direction, angular velocities "
    "counter-clockwise.",
    rules={
        "held": "Held at its value while the drive moves: {all}.",
        "lever": "Lever rule: about the pivot {first} the velocities of {rest} are proportional "
        "to their arms.",
        "arm": "The link turns about the pivot {first}: the velocity of {rest} is the angular "
        "velocity times the arm.",
        "projection": "Equal-projection theorem (velocities of two points of a rigid body): on the "
        "line {joined} the velocities of {all} have equal projections.",
        "circular_slot": "Circular slot of {point}: relative to this link the pin {second} moves "
        "along the tangent, so that on the radius {first} the velocities of {last} and {second} "
        "have equal projections.",
        "radius": "Angular velocity of the radius {first} of the circular slot from the "
        "velocities of its ends.",
        "turning_radius": "The velocities of {rest} differ by that of the rotation of the radius "
        "{first} of the circular slot.",
        "rotation": "Angular velocity of the link {joined} from the velocities of its points.",
        "translation": "The velocities of {rest} are parallel, and their projections on the line "
        "between these points are equal: the link {first} translates.",
        "equal_velocities": "The velocities of {rest} are equal: the link {first} translates.",
        "parallel_guides": "The guides of {rest} are parallel: the link {first} translates.",
        "body": "Plane motion of the link {first}: the velocity of one point and the rotation "
        "about it give the velocity of another ({rest}).",
        "plane": "Plane motion of the link {first}: the velocity of {last} is that of {second} "
        "together with that of the rotation about {second}.",
        "dyad": "Dyad {joined}: the velocity of the common pin follows from its projections on "
        "the two links.",
        "together": "The relations for {all} are solved together.",
        "guide": "The guide fixes the direction of the velocity of {all}.",
        "turning": "The link {first} slides along {rest} without turning on it: both have equal "
        "angular velocities.",
        "slot": "The pin {first} slides in {rest}: across the slot the pin and the body"
        " under it have equal velocities.",
        "contact": "The point {first} touches {rest}: along the common normal both have "
        "equal velocities.",
        "gear": "The gears on {all} roll on one another: their pitch circles have equal"
        " speeds at the pitch point.",
        "belt": "The belt does not slip on the pulleys {all}: the speeds of their rims are equal.",
        "on_arm": "Seen from the link {first}, which carries the centres {rest}, the rims of both "
        "wheels have equal speeds (Willis).",
        "rack": "The rack {rest} moves with the pitch circle of the gear on {first}.",
        "screw": "The screw moves {rest} by its lead in each turn.",
        "rope": "The rope through {all} keeps its length: what its falls gain and lose adds "
        "up to zero.",
        "parting": "Rate of the distance between {all}: the difference of their velocities"
        " along the line through them.",
        "component": "Component of the velocity of {first} in the direction of the load {rest}.",
        "component_of_rotation": "Rotation about the pivot {first}: velocities are proportional to "
        "their arms, the component of the velocity of {point} in the direction of the load {last} "
        "to the arm of this load.",
        "component_of_body": "Plane motion of the link {first}: in the direction of the load "
        "{last} the component of the velocity of {point} is that of the velocity of {second} "
        "together with that of the rotation about {second}.",
        "component_of_translation": "Translation of the link {first}: the velocity of {point} is "
        "that of {second}, here its component in the direction of the load {last}.",
        "component_of_two": "The projections of the velocity of {first} on two lines are known; "
        "they give its component in the direction of the load {last}.",
    },
    sentences=forces_and_friction.WORDS,
    again={
        "projection": "Likewise on the line {joined} the velocities of {all} have equal "
        "projections.",
        "circular_slot": "Likewise in the circular slot of {point} the velocities of {last} and "
        "{second} have equal projections on the radius {first}.",
        "lever": "Likewise about the pivot {first} the velocities of {rest} are proportional to "
        "their arms.",
        "arm": "Likewise about the pivot {first} the velocity of {rest} is the angular velocity "
        "times the arm.",
        "slot": "Likewise the pin {first} slides in {rest}: their velocities across the slot "
        "are equal.",
        "contact": "Likewise {first} and {rest} have equal velocities along their common normal.",
        "rack": "Likewise the rack {rest} moves with the pitch circle of the gear on {first}.",
        "screw": "Likewise the screw moves {rest} by its lead in each turn.",
        "translation": "Likewise the link {first} translates: the velocities of {rest} are equal.",
        "component_of_translation": "Likewise the velocity of {point} is that of {second}, here "
        "its component in the direction of the load {last}.",
        "plane": "Likewise the velocity of {last} on {first} is that of {second} together with "
        "that of the rotation about {second}.",
        "component_of_rotation": "Likewise about {first} the component of the velocity of {point} "
        "in the direction of the load {last}.",
        "component_of_body": "Likewise, by the plane motion of {first} with the velocity of "
        "{second}, the component of the velocity of {point} in the direction of the load {last}.",
    },
    held="The drive ({loads}) is held still.",
    hence="hence",
    power="Power equation",
    power_rule="Principle of virtual powers: in equilibrium the powers of all loads add up to "
    "zero in every possible motion.",
    powers={
        "projections": "In the power of a force the velocity of its point counts by its "
        "projection on the line of action: {speeds}.",
        "projection": "{speed} for {load}",
        "halves": "The factor {number} of {loads}: such a load acts in both mirrored halves.",
        "parts": "The factor {number} of {loads}: such a load acts in each of the "
        "{number} equal parts.",
    },
    several="The mechanism has {count} degrees of freedom, hence {count} equations.",
    results="Results",
    further="Further quantities",
    force_ratio="Force transmission coefficient",
    load="Load",
    speed_ratio="Velocity ratio",
    transmission_ratio="Transmission ratio",
    opposite_senses="Angular velocities are positive counter-clockwise here: at the values given "
    "these two have opposite senses.",
    opposite_along_guides="Velocities are positive along their guides here, angular ones "
    "counter-clockwise: at the values given these two have opposite senses.",
    against="The minus of {result} means: at the values given {drive} acts against its arrow.",
    against_load="The minus of {result} means: at the values given {drive} acts against its arrow "
    "while {load} acts along its own.",
    at_joints={
        "joint": "force at {point}",
        "on": "force at {point} on {link}",
        "guide": "force of the guide at {point}",
        "normal": "normal force at {point}",
        "rod": "force in the rod {line}",
        "slot": "force of the circular slot at {point}",
        "rope": "tension of the rope {line}",
        "size": "{force}",
        "x": "{force}, x component",
        "y": "{force}, y component",
        "direction": "{force}, its direction",
        "with friction": "{force}, with friction",
    },
    with_friction={
        "drives": "With friction, {drive} drives",
        "driven": "With friction, {drive} is back-driven",
        "returns": "With friction, {drive} drives the return",
        "tightening": "With friction, the motion along the arrow of {drive}",
        "releasing": "With friction, the motion against the arrow of {drive}",
        "first": "With friction, to first order",
    },
    efficiency="Efficiency",
    where="where",
    solve="{names}: the solution of the equations (on the branch of the values given):",
    proportional="{result} is proportional to {factor}.",
    inverse="{result} is inversely proportional to {factor}.",
    independent="{result} does not depend on {names}.",
    swaps="{result} does not change when {first} and {second} change places.",
    trends={
        "rises": "{within}{result} rises with {names}.",
        "falls": "{within}{result} falls with increasing {names}.",
        "rises between poles": "{within}{result} rises with {names} on either "
        "side of each value at which it becomes infinite.",
        "falls between poles": "{within}{result} falls with increasing {names} "
        "on either side of each value at which it becomes infinite.",
        "constant": "{result} does not change with {names}.",
        "turns": "{within}{result} does not vary monotonically with {names}.",
        "unknown": "",
    },
    within={
        "always": "",
        "ranges": "Within the ranges given, ",
        "ranges, rest as given": "Within the ranges given and with the rest at the values given, ",
        "rest as given": "With the rest at the values given, ",
        "as given": "At the values given, ",
    },
    zero="{result} vanishes when {condition}",
    pole="{result} becomes infinite when {condition}",
    infinite="Of {result} nothing is said where {condition}: there {name} is infinite, and "
    "{result} may jump.",
    when="that is, at {condition}",
    and_every="{first} and every {period} from there on",
    unmet="; sampling finds none for {span} and the values given",
    absent="; this does not occur for {span} and the values given",
    but_where="except perhaps where {conditions} as well",
    causes={
        "dead centre": "dead centre: {still} while {moving}",
        "still": "{name} stands still",
        "still distance": "the distance {name} does not change",
        "moves": "{name} moves",
        "moves distance": "the distance {name} changes",
        "perpendicular load": "the load is perpendicular to the velocity of its point",
        "other": "",
    },
    states={
        "locked": "Self-locking: {load} alone cannot move the mechanism",
        "locked, driving": "No force {load} can move the mechanism",
        "jammed": "Jammed: no force {drive} can move the mechanism",
    },
    all_loads="the load",
    as_given="at the values given",
    where_it_holds="for {condition}",
    any_of="any {name}",
    in_range="in the range given for {condition}",
    all_of_range="in the whole range given",
    out_of_range="outside the range given",
    out_of_ranges="outside the ranges given",
    efficiency_range="For {condition}, {result} runs from {least} to {greatest}",
    steady="For {condition}, {result} is {least} throughout",
    still="{least} (nothing moves)",
    usual="it is between 0.9 and 0.95 for {conditions} only",
    always_usual="it is between 0.9 and 0.95 throughout",
    unusual="it is nowhere between 0.9 and 0.95",
    why_usual="An efficiency of 0.9 to 0.95 is what textbooks assume of oiled joints.",
    sampled="These bounds are found by sampling and refined, not proved.",
    fails_here="At the values given this formula does not hold: with friction a force has another "
    "sense there than it assumes. The value follows from the equilibrium of all links together.",
    at_rest={
        "limit": "At the values given a joint does not slide for an instant, and its friction has "
        "no sense there: the value is the limit as these values are approached.",
        "jump": "At the values given a joint does not slide for an instant, and its friction has "
        "no sense there: the result jumps.",
    },
    extents={
        "whole": "For {span}, the rest at the values given, {parts} (found by sampling "
        "and refined).",
        "0 all over": "{result} is 0 at all places looked at",
        "0 throughout": "{result} is 0 at all places looked at for {spans}",
        "0": "{result} is 0 at {places}",
        "infinite": "{result} is infinite at {places}",
        "ends": "With the rest at the values given, {result} is {pairs}.",
        "ends alone": "{result} is {pairs}.",
        "pair": "{low} at {first} and {high} at {last}",
        "neither": "{result} is neither 0 nor infinite",
        "no zeros": "{result} is nowhere 0",
        "no poles": "{result} is nowhere infinite",
        "least": "the least {result} is {value}, at {place}",
        "greatest": "the greatest {result} is {value}, at {place}",
    },
    derivatives="Sensitivities (partial derivatives)",
    slope="Derivative with respect to the driving coordinate",
    calculation={
        "title": "Calculation",
        "tables": "Tables and lists of sizes",
        "lines": "Calculation",
        "checks": "Checks",
        "list": "the next size of the list {name}",
        "row": "the row of the table {name}",
        "between": "in proportion between two rows: {source}",
        "unknown": "not known",
        "missing": "not known without a value of {names}",
        "unused": "Not used here: {names}.",
        "fails": "FAILS",
        "least of all": "the least",
        "decides": "{formula} decides",
        "otherwise": "otherwise",
        "case": "{value} when {condition}",
        "other": "else {value}",
        "of table": "{name} at {asked}",
        "of row": "{name} at exactly {asked}",
        "of list": "next {asked} in {name}",
        "condition": "Condition",
        "numbers": "In numbers",
        "reserve": "Reserve",
        "verdict": "Verdict",
        "holds": "holds",
        "least": "holds, the least reserve",
        "derived": "Results of the mechanism, derived below",
        "taken": "Results of the mechanism",
        "mechanism": "Mechanism {prefix}",
        "index": "In the calculation its quantities have the index {prefix}; "
        "here they stand as in its own description, at the values that the calculation gives it.",
    },
    pictures=pictured.WORDS,
    checked=checked.WORDS,
    along_stroke=along_stroke.WORDS,
    comparison={"number": "No.", "scheme": "Scheme", "results": "Force transmission"},
    holds="This holds while {conditions}.",
    holds_as="This holds under the same conditions as {result}.",
    same_as="{result} = {other}: what is said of {other} holds for it, too.",
    inverse_of={
        "limits": "where {other} vanishes, {result} becomes infinite, and vice versa",
        "trends": "where {other} rises, {result} falls, and vice versa",
    },
    multiple_of={
        "limits": "{result} vanishes or becomes infinite where {other} does",
        "trends": "with {names} it rises or falls as {other} does",
        "opposite trends": "with {names} it falls where {other} rises, and vice versa",
        "extremes": "it is least and greatest where {other} is",
        "opposite extremes": "it is least where {other} is greatest, and vice versa",
    },
    requirements="The result holds for",
    numbers="Numerical values",
    at_default="At the values given",
    undetermined="undetermined",
    no_direction="undetermined, as the force is zero",
    agrees="Check: the equilibrium of the free bodies gives the same result in {count} poses "
    "(largest relative difference {error}).",
    agrees_once="Check: the equilibrium of the free bodies gives the same result in one pose "
    "(largest relative difference {error}).",
    disagrees="Check failed: the equilibrium of the free bodies gives another result (relative "
    "difference {error}).",
    pending="The equilibrium of the free bodies has not been compared.",
    conjunction="and",
    disjunction="or",
    negation="or",
    subscripts={
        "hold": "hold",
        "guide": "guide",
        "face": "face",
        "gear": "gear",
        "belt": "belt",
        "rack": "rack",
        "screw": "screw",
        "collar": "collar",
        "rope": "rope",
    },
    units={},
)
