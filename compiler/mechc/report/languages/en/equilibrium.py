"""What sentences about the equilibrium of free bodies say."""

WORDS = {
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
    "made up by ground": "The force of the ground at {point} balances all that acts there:",
    "forces per load": "These forces, divided by {load}:",
    "solved together": "These equations together give",
}
