"""The syntax tree: what was written, in either notation, with its places.

Nothing is resolved here: names are text, numbers are the digits that were typed,
an order of statements is the order of the file. Both parsers build it and both
printers write it, so ``to_dsl(from_yaml(to_yaml(tree)))`` and ``to_dsl(tree)`` are
the same text (spans aside).

Its modules are the parts of the language; the folder has the names of all.

Sums and products are flat (a sum of 2,000 terms is one node), so that a tree is
never deeper than the nesting its author wrote, which the parsers limit to 64.
"""

from .description import File as File
from .description import Heading as Heading
from .description import Reported as Reported
from .description import SheetHeading as SheetHeading
from .description import SourceNote as SourceNote
from .description import Statement as Statement
from .description import Translate as Translate
from .description import Version as Version
from .expressions import Axis as Axis
from .expressions import Call as Call
from .expressions import Cartesian as Cartesian
from .expressions import Direction as Direction
from .expressions import Expr as Expr
from .expressions import Name as Name
from .expressions import Number as Number
from .expressions import Polar as Polar
from .expressions import Power as Power
from .expressions import Product as Product
from .expressions import Sum as Sum
from .expressions import Symbol as Symbol
from .expressions import Toward as Toward
from .forces import Actuator as Actuator
from .forces import BeltFriction as BeltFriction
from .forces import CollarFriction as CollarFriction
from .forces import ContactFriction as ContactFriction
from .forces import Distributed as Distributed
from .forces import Efficiency as Efficiency
from .forces import Force as Force
from .forces import Friction as Friction
from .forces import GearFriction as GearFriction
from .forces import Gravity as Gravity
from .forces import GuideFriction as GuideFriction
from .forces import Load as Load
from .forces import Motion as Motion
from .forces import NamedLoad as NamedLoad
from .forces import PinFriction as PinFriction
from .forces import RackFriction as RackFriction
from .forces import RollerFriction as RollerFriction
from .forces import RopeFriction as RopeFriction
from .forces import ScrewFriction as ScrewFriction
from .forces import Spring as Spring
from .forces import Torque as Torque
from .forces import Weight as Weight
from .linkage import Assembly as Assembly
from .linkage import Belt as Belt
from .linkage import Contact as Contact
from .linkage import Copies as Copies
from .linkage import Drawn as Drawn
from .linkage import Drive as Drive
from .linkage import Fall as Fall
from .linkage import Gear as Gear
from .linkage import Link as Link
from .linkage import Mirror as Mirror
from .linkage import Pivot as Pivot
from .linkage import Rack as Rack
from .linkage import Rope as Rope
from .linkage import Screw as Screw
from .linkage import Slide as Slide
from .linkage import Slider as Slider
from .linkage import Slot as Slot
from .linkage import Telescope as Telescope
from .linkage import Transmission as Transmission
from .linkage import Turn as Turn
from .linkage import Vector as Vector
from .quantities import Branch as Branch
from .quantities import Brought as Brought
from .quantities import Choice as Choice
from .quantities import Condition as Condition
from .quantities import Expect as Expect
from .quantities import Find as Find
from .quantities import Follows as Follows
from .quantities import Given as Given
from .quantities import Let as Let
from .quantities import LetValue as LetValue
from .quantities import Lookup as Lookup
from .quantities import NextSize as NextSize
from .quantities import Param as Param
from .quantities import Require as Require
from .quantities import Sizes as Sizes
from .quantities import Table as Table
from .quantities import Taken as Taken
from .quantities import Use as Use
