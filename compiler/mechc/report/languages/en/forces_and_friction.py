"""What the sentences of a derivation say of forces and friction."""

EQUILIBRIUM = {
    "equilibrium": "Each body is in equilibrium under all that acts on it.",
    "equal parts": "By symmetry one of the equal parts is considered; on what they share all of "
    "them act.",
    "force in rod": "{force} is the force in the rod {link}, positive in tension.",
    "force of circular slot": "{force} is the force of the circular slot of {link} on {point}, "
    "positive towards {rest}.",
    "forces across radius": "Forces on {link} perpendicular to the radius {rod} of the circular "
    "slot:",
    "pin across radius": "Forces on the pin {point} perpendicular to the radius {rod} of the "
    "circular slot:",
    "force of ground": "{force} and {other} are the components of the force of the ground on "
    "{link} at {point}.",
    "force at pin": "{force} and {other} are the components of the force on {link} at the pin "
    "{point}; the opposite acts on what it is joined to.",
    "force along arm": "{force} and {other} are the components, along {arm} and perpendicular to "
    "it, of the force on {link} at the pin {point}; the opposite acts on what it is joined to.",
    "force of guide": "{force} is the force of the guide on {point}, positive to the left of the "
    "guide’s direction.",
    "force of touch": "{force} is the force of {link} on {point}, along the normal.",
    "force of rim": "{force} is the circumferential force between the wheels on {first} and "
    "{rest}, positive where it turns that on {first} counter-clockwise.",
    "force of rack": "{force} is the force of the gear on {pivot} on the rack at {point}, positive "
    "in the direction of the guide.",
    "force of thread": "{force} is the axial force of the screw {link} on {point}, positive in the "
    "direction of the guide.",
    "force of rope": "{force} is the tension of the rope from {first}.",
    "couple in slot": "{force} is the couple of {rest} on {link}, positive counter-clockwise.",
    "forces along": "Forces on {link} in the direction {direction}:",
    "forces across": "Forces on {link} perpendicular to the rod {rod}:",
    "pin along": "Forces on the pin {point} in the direction {direction}:",
    "pin across": "Forces on the pin {point} perpendicular to the rod {rod}:",
    "made up": "The force on {link} at {point} is the sum of those that act on it there:",
    "made up by ground": "The reaction at {point} balances all that acts there:",
    "forces per load": "These forces, divided by {load}:",
    "solved together": "These equations together give",
}
"""What sentences about the equilibrium of free bodies say."""

WORDS = {
    **EQUILIBRIUM,
    "released": "Release of constraints: a constraint is taken away, its reaction becomes a "
    "load, and the powers of all loads add up to zero in the motion that is left.{held}",
    "pivot": "Let the pivot {point} move in the direction {direction} with the velocity "
    "{speed}; {force} is its reaction in this direction.",
    "guide": "Let {point} leave its guide in the direction {direction} with the velocity "
    "{speed}; {force} is the reaction of the guide.",
    "pin": "Let the link {link} part from the pin {point} in the direction {direction} with "
    "the velocity {speed}; {force} is the force between them.",
    "touch": "Let {point} part from the surface that it touches in the direction {direction} "
    "with the velocity {speed}; {force} is the force between them.",
    "circular slot released": "Let the circular slot of {link} give way in the direction "
    "{direction} with the velocity {speed}; {force} is its force.",
    "rope released": "Let the rope that begins at {point} grow shorter with the velocity "
    "{speed}; {force} is its tension.",
    "idle": "Let the constraint at {point} be released in the direction {direction}: no load "
    "does work then, and this component is zero.",
    "rod": "No load acts on the rod {link} between its pins, so that the force acts along its "
    "line.",
    "smooth": "The force of the guide of {point} is perpendicular to it.",
    "shared": "At {point} the forces of the equal parts across the line of symmetry cancel.",
    "tightening": "The motion is along the arrow of {drive}; friction opposes the sliding in "
    "every joint.",
    "tightening, held back": "The motion is along the arrow of {drive}, which only just holds it "
    "back; friction opposes the sliding in every joint.",
    "releasing": "The motion is against the arrow of {drive}; friction opposes the sliding in "
    "every joint.",
    "releasing, held back": "The motion is against the arrow of {drive}, which only just holds "
    "it back; friction opposes the sliding in every joint.",
    "tightening, the return": "The motion is along the arrow of {drive}: at the values given the "
    "mechanism is self-locking, so that {drive} has to drive it back; friction opposes the sliding "
    "in every joint.",
    "releasing, the return": "The motion is against the arrow of {drive}: at the values given the "
    "mechanism is self-locking, so that {drive} has to drive it back; friction opposes the sliding "
    "in every joint.",
    "releasing, by the load": "{drive} drives, and the motion is against the arrow of {load}; "
    "friction opposes the sliding in every joint.",
    "tightening, negative": "The motion is along the arrow of {drive}, which is negative at the "
    "values given: it only just holds the motion back; friction opposes the sliding in every "
    "joint.",
    "releasing, negative": "The motion is against the arrow of {drive}, which is negative at the "
    "values given and so drives it; friction opposes the sliding in every joint.",
    "pin friction": "The friction in a pin is a couple: the force on the pin times the radius "
    "{radius} of the friction circle.",
    "guide friction": "The friction of a guide is its coefficient times the normal force.",
    "load with friction": "{whole} is the value of {load} with friction.",
    "rod forces": "{force} is the magnitude of the whole force that a rod passes on from pin to "
    "pin, whether compressive or tensile.",
    "part": "By symmetry one of the equal parts is considered.",
    "unit": "Forces are given per unit of {load}.",
    "unit and drive": "Forces are given per unit of {load}, so that {drive} is {ratio}.",
    "times the load": "The forces found above per unit of {load} are multiplied by {load}.",
    "pressed": "The rod {link} is in compression.",
    "pulled": "The rod {link} is in tension.",
    "crossed": "The force in {link} acts along the internal common tangent of the friction "
    "circles at its ends, as it turns the same way on both pins.",
    "outer": "The force in {link} acts along an external common tangent of the friction "
    "circles at its ends, as it turns on its pins in opposite ways.",
    "parallel": "The force in {link} keeps its direction: the external common tangent of equal "
    "friction circles is parallel to it.",
    "single": "The force in {link} touches the friction circle of the pin {point} and goes through "
    "the middle of the pin at the other end, where no friction acts.",
    "face": "The whole force {force} of the face on {point}, the normal force with friction, "
    "is turned from the normal by the angle of friction.",
    "moments": "Moments about {point} of the forces on {link}:",
    "turns left": "The link {link} turns counter-clockwise. Moments about {point} (on the right "
    "that of the friction in the pivot):",
    "turns right": "The link {link} turns clockwise. Moments about {point} (on the right that of "
    "the friction in the pivot):",
    "squared": "Squaring gives a quadratic equation:",
    "along": "Forces on {point} along its guide:",
    "along with friction": "Forces on {point} along its guide (on the right its friction):",
    "pin of rods": "Forces on the pin {point}, across each of the rods:",
    "first order": "To first order the joints carry the same forces as without friction. Each "
    "joint with friction adds its coefficient times the force {force} times the sliding velocity, "
    "per unit of the drive’s velocity.",
    "first order, same": "To first order the joints carry the same forces as without friction, "
    "which here gives the same result.",
    "first order, less": "To first order the joints carry the same forces as without friction. "
    "Each joint with friction takes away its coefficient times the force {force} times the "
    "sliding velocity, per unit of the drive’s velocity.",
    "slip of pin": "In a pin the relative angular velocity {turn} takes the place of the sliding "
    "velocity, and the radius of the friction circle that of the coefficient.",
    "slip of circular slot": "In a circular slot the angular velocity {turn} of its radius "
    "relative to the link with the slot takes the place of the sliding velocity, and the radius "
    "of the friction circle about the centre of the slot that of the coefficient.",
    "slip of face": "On a sliding surface {speed} is the sliding velocity.",
    "pressing of thread": "In a thread {force} is the axial component of the normal force.",
    "slip of thread": "In a thread {force} is the axial component of the normal force, and {speed} "
    "is the sliding velocity divided by the cosine of the lead angle.",
    "pressing of rim": "In gears, belts and racks {force} is the force that is passed on.",
    "slip of rim": "In gears, belts and racks {force} is the force that is passed on, and {speed} "
    "is the velocity of the pitch circle.",
    "rope friction": "Where a rope or band slides around a pulley or drum, the tension on one "
    "side is {ratio} times that on the other, {angle} being the angle of wrap (Euler, Eytelwein).",
    "rope, smaller tension": "{force} is the smaller of the two, which the equilibrium of the "
    "bodies gives; their difference is the friction on the pulley.",
    "rope, mean": "The mean of both tensions counts as the normal force, with the coefficient "
    "{part}.",
    "ropes": "The power of friction is the difference of the tensions times the sliding velocity "
    "{speed}, per unit of the drive’s velocity:",
    "straight": "Each friction force is its coefficient times the normal force {force}, which "
    "equilibrium gives under the loads and the friction forces. Its power is this times the "
    "sliding velocity {speed}, per unit of the drive’s velocity:",
    "straight, known": "Each friction force is its coefficient times the normal force {force}, "
    "which friction does not change. Its power is this times the sliding velocity {speed}, per "
    "unit of the drive’s velocity:",
    "efficient": "The efficiency is given: the part of the driving power that reaches the load.",
    "powers of friction": "Each joint with friction adds its coefficient times the force {force} "
    "times the sliding velocity, per unit of the drive’s velocity.",
    "pressing": "Each friction force is its coefficient times the normal force {force}, which "
    "equilibrium gives under the loads and the friction forces:",
    "added by friction": "The force without friction, and what each friction force adds to it:",
    "part along the rod": "{force} is the component along the rod of {whole}, the whole force that "
    "it passes on, and is positive in tension:",
    "whole of the rod": "The force on {link} at {point} is the whole force that the rod passes on; "
    "its components are:",
    "part along the normal": "{force} is the component along the normal of {whole}, the whole "
    "force on {point}:",
    "across": "Forces on {point} across its guide:",
    "balance": "The force on {link} at {point} balances all other forces on it:",
    "unloaded": "Nothing presses the joints that have friction, so friction changes nothing.",
    "iterated equation": "Here the friction depends on a force that it changes itself. For this "
    "force {sizes} equilibrium gives an equation, which Newton’s method solves, starting from the "
    "ideal force:",
    "iterated equations": "Here each friction force depends on the others. For the forces "
    "{sizes} at the joints equilibrium gives equations, which Newton’s method solves, starting "
    "from the ideal forces:",
    "iterated again": "The forces {sizes} follow likewise.",
    "iterated alone again": "The force {sizes} follows likewise.",
    "iterated alone": "Here the friction depends on a force that it changes itself. With {sizes} "
    "this force, {parts} its components without friction and {changes} the changes that friction "
    "makes in them, {sizes} = {whole}, which Newton’s method solves, starting from the ideal "
    "force.",
    "iterated": "Here each friction force depends on the others. With {sizes} the forces at the "
    "joints, {parts} their components without friction and {changes} the changes that all "
    "friction makes in them, {sizes} = {whole}, which Newton’s method solves, starting from the "
    "ideal forces.",
}
