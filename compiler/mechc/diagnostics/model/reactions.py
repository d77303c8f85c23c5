"""Messages for forces at joints that are asked for (E25x)."""

from collections.abc import Sequence

from ...source import Span
from ..diagnostic import Message, Related, coded


@coded("E250")
def on_which_link(span: Span, point: str, links: Sequence[str]) -> Message:
    """A pin between links transmits another force to each of them.

    By itself ``R_O`` is the force of the ground, at a pivot or a slider. Anywhere else the
    link is named.

        find R_B           # wrong where B joins AB and BC
        find R_B on AB     # right: the force on AB, by all that meets it at B
    """
    message = f"point {point} is not held by the ground, so R_{point} needs a link"
    if len(links) == 1:
        alone = f"only link {links[0]} goes through {point}: is 'pivot {point}' missing?"
        return Message(span, message, alone)
    hint = " or ".join(f"'find R_{point} on {link}'" for link in links[:3])
    return Message(span, message, f"write {hint}" if hint else f"join a link to {point}")


@coded("E217")
def guide_of_copies(span: Span, point: str, link: str) -> Message:
    """The force of a guide is asked for at a slider that several copies share.

    Each branch pushes it sideways. How these forces add up depends on where the branches stand:
    around an axis they cancel, side by side they do not. No line says which::

        slider K along y
        copies 3 sharing K
        find R_K           # wrong, as is find N_K
        find R_K on KA     # right: the force on one branch
    """
    message = f"the branches share {point}: how they push on its guide depends on how they stand"
    hint = f"'find R_{point} on {link}' is the force on one branch" if link else "leave it out"
    return Message(span, message, hint)


@coded("E251")
def point_of_another(span: Span, point: str, link: str) -> Message:
    """The force on a link is asked for at a point that is not one of its own.

    link AB
    link BC
    find R_C on AB     # wrong
    find R_C on BC     # right
    """
    message = f"point {point} is not a point of link {link}"
    return Message(span, message, f"name a link with {point} behind 'on'")


@coded("E252")
def no_joint(span: Span, point: str, link: str, fall: str) -> Message:
    """The force of a joint is asked for where nothing is joined to the link.

    A load that acts there is not a force of a joint, nor is the tension of a rope.

        link OA
        force F at A along y
        find R_A on OA     # wrong: nothing but F is at A
        find R_O           # right
    """
    message = f"nothing is joined to link {link} at {point}, so no joint exerts a force there"
    load = "a load that acts there is known by its own name"
    return Message(span, message, f"a rope has a tension: 'find N_{fall}'" if fall else load)


@coded("E253")
def not_a_rod(span: Span, link: str, number: int, pin: str) -> Message:
    """``N_AB`` is the force along a rod, a link of two points.

    link BOD
    find N_BO            # wrong: the link is bent and sheared as well
    find R_B on BOD      # right
    """
    message = f"link {link} has {number} points, so no single force acts along it"
    return Message(span, message, f"ask for the force at a pin, as in 'find R_{pin} on {link}'")


@coded("E256")
def several_in_contact(span: Span, point: str) -> Message:
    """A pin is in several slots or contacts, and one of them is named by it.

    slot A in OB
    slot A in QC
    find N_A     # wrong: of which slot?
    """
    message = f"{point} is in several slots or contacts, and this does not tell which"
    return Message(span, message, "let a link with a pin of its own be in one of them")


@coded("E254")
def nothing_normal(span: Span, point: str) -> Message:
    """``N_A`` is the force of a guide, a slot or a contact on point A, or on the slide of A.

    pivot O
    find N_O     # wrong: a pivot has no normal
    find R_O     # right
    """
    message = f"point {point} is neither guided nor in contact, so it has no normal force"
    return Message(span, message, f"the force on a pin is R_{point}")


@coded("W259")
def force_of_the_ground(span: Span, point: str, links: Sequence[str]) -> Message:
    """The force of the ground is asked for at a pivot of several links, or of both halves.

    They press on each other through the pin, and what they press so does not reach the
    ground: of pliers ``R_O`` is zero, and a pin must not be sized by it.

        mirror across x sharing O
        find R_O            # what the ground gives to the whole
        find R_O on OCA     # what the pin gives to link OCA: for its strength
    """
    hint = " or ".join(f"'find R_{point} on {link}'" for link in links[:3])
    message = f"R_{point} is the force of the ground alone, not what links give each other there"
    return Message(span, message, f"for the strength of the pin write {hint}")


@coded("W299")
def load_on_the_pin(
    span: Span, load: str, point: str, link: str, others: Sequence[str], at: Span
) -> Message:
    """The force of a pin on a link is asked for, and a load acts at the pin itself.

    A load at a shared pin that names no link acts on the pin, so that the pin hands it on
    with what the other links give. Where the link carries it, the pin gives that much less::

        force P at B along x           # warned of beside `find R_B on OB`
        force P at B on OB along x     # OB carries P: R_B on OB is what BK gives
        force P at B on BK along x     # R_B on OB is what BK gives with P on it
    """
    said = " or ".join(f"'{point} on {each}'" for each in (link, *others))
    message = f"{load} acts on the pin at {point}, so that the force on {link} there has it in it"
    return Message(span, message, f"say which link carries it: {said}", (Related(at, "the load"),))


@coded("E255")
def ask_first(span: Span, name: str) -> Message:
    """A force at a joint may stand in a formula once it is asked for.

    find R_O
    let stress = R_O/A     # right
    """
    return Message(
        span, f"{name} is a force at a joint that nothing asks for", f"add 'find {name}'"
    )


@coded("E286")
def link_named_for_nothing(span: Span) -> Message:
    """``on`` says which link's pin force is meant, so it stands only with ``R_B``.

    find P on AB       # wrong
    find R_B on AB     # right
    """
    return Message(span, "'on' stands only with a pin force such as R_B", "remove it")


@coded("E347")
def tension_of_sliding_rope(span: Span, fall: str, loads: Sequence[str]) -> Message:
    """The tension of a rope is asked for that slides around a pulley, and changes there.

    N_AB is the tension of a rope that has one all along. With friction at a pulley each fall
    has its own. That of the fall at whose end a load acts follows from the load::

        rope A, B along y, H along -y
        friction rope B 0.2 wrap 180 deg
        find N_AB                            # wrong
    """
    message = f"the rope along {fall} slides around a pulley, and its tension changes there"
    hint = "without the friction of the rope it has one"
    if loads:
        hint += f"; what pulls at its end is 'find {loads[0]}'"
    return Message(span, message, hint)


@coded("E259")
def loaded_at_both_ends(span: Span, link: str) -> Message:
    """The force along a rod is asked for, and loads act on the rod itself at both its ends.

    N_AB is what the pin at an end without such a load gives the rod. Between two loaded ends
    it is neither pin's force.

        force F at B on AB along x
        force G at A on AB along x
        find N_AB                  # wrong
        find R_A on AB             # right: what the pin at A does to the rod
    """
    message = f"loads act on {link} itself at both ends, so that no pin gives the force along it"
    return Message(span, message, "ask for the forces at its pins, as in 'find R_A on AB'")
