"""Mechanisms by the coordinates of their pins, as they stand in collections and textbooks.

Each is given without loads' values and with a drive where it has one; without the drive it
is the drawn pose alone.
"""

DRAWN = {
    "four_bar": """
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
link OA
link AB
link CB
A at (20 mm, 34.64 mm)
B at (80 mm, 59.64 mm)
drive OA from 10 deg to 80 deg
torque M on OA
torque T on CB
find k = M/T
""",
    "four_bar_crossed": """
pivot O at (0 m, 0 m)
pivot Q at (4 m, 0 m)
link OA
link AB
link QB
A at (-2 m, 0 m)
B at (5.16667 m, -5.88548 m)
drive OA from 150 deg to 210 deg
torque M on OA
torque T on QB
find k = M/T
""",
    "crank_and_slide": """
pivot O at (0 mm, 0 mm)
slide WX along x
link OA
link AX
W at (100 mm, 0 mm)
X at (80 mm, 10 mm)
A at (10 mm, 20 mm)
drive OA from 20 deg to 80 deg
torque M on OA
force F at W along -x
find k = M/F
""",
    "slider_crank": """
pivot O at (0 mm, 0 mm)
slider B along x
link OA
link AB
A at (30 mm, 40 mm)
B at (150 mm, 0 mm)
drive OA from 10 deg to 170 deg
torque M on OA
force F at B along x
find k = M/F
""",
    "inclined_slider_crank": """
pivot O at (3 mm, -7 mm)
slider B along 35 deg
link AO
link AB
A at (23 mm, 24 mm)
B at (118 mm, 61 mm)
drive OA from 10 deg to 100 deg
torque M on OA
force F at B along -AB
find k = M/F
""",
    "inverted_slider_crank": """
pivot O at (0 mm, 0 mm)
pivot C at (0 mm, -60 mm)
link OA
link CD
slot A in CD
slider E along x
link DE
A at (20 mm, 20 mm)
D at (60 mm, 180 mm)
E at (160 mm, 170 mm)
drive OA from 20 deg to 160 deg
torque M on OA
force F at E along x
find k = M/F
""",
    "quick_return": """
pivot O at (0 m, 0 m)
pivot Q at (5 m, 0 m)
link OA
link QC
slot A in QC
A at (1.2 m, 1.6 m)
drive OA from 20 deg to 160 deg
torque M on OA
torque T on QC
find k = M/T
""",
    "double_butterfly": """
pivot O at (0 m, 0 m)
pivot R at (7.4 m, 4.2 m)
pivot S at (13 m, 0 m)
link OA
link ABC
link CD
link RDE
link EF
link BFG
link SG
D at (5.9286 m, 2.85 m)
E at (4.4152 m, 3.9 m)
A at (4.1276 m, 11.27 m)
B at (10.4289 m, 14.25 m)
C at (6.4193 m, 9.7727 m)
F at (6.8309 m, 12.57 m)
G at (8.1434 m, 9.87 m)
drive OA from 62 deg to 72 deg
torque M on OA
torque T on RDE
find k = M/T
""",
    "triad": """
pivot O at (100 mm, 100 mm)
pivot B at (400 mm, 175 mm)
pivot C at (175 mm, 350 mm)
link OA
link AD
link BE
link CF
link DEF
A at (100 mm, 175 mm)
D at (200 mm, 200 mm)
E at (300 mm, 200 mm)
F at (250 mm, 300 mm)
drive OA from 80 deg to 100 deg
torque M on OA
force P at F along y
find k = M/P
""",
    "excavator_stick": """
pivot O at (0 m, 0 m)
pivot C at (-1.4 m, 0.55 m)
link BOE "stick"
telescope CB
B at (0.1 m, 0.69 m)
E at (-0.4 m, -2.77 m)
drive CB from 1.3 m to 2 m
actuator P between C and B
force F at E along x
find k = P/F
""",
    "landing_gear": """
pivot O at (0 m, 0 m)
pivot Q at (-1.2 m, 0.05 m)
pivot C at (0.5 m, 0.15 m)
link OBAW "leg"
link AK
link QK
telescope CB
B at (-0.03 m, -0.34 m)
A at (-0.09 m, -0.9 m)
W at (-0.15 m, -1.49 m)
K at (-0.8 m, -0.61 m)
drive CB from 0.69 m to 0.73 m
actuator P between C and B
force G at W along -x
find k = P/G
""",
    "jansen_like": """
pivot O at (0 mm, 0 mm)
pivot Q at (-38 mm, -7.8 mm)
link OA
link AB
link QBC
A at (10 mm, 11.18 mm)
B at (-20 mm, 30 mm)
C at (-70 mm, 5 mm)
drive OA from 0 deg to 360 deg
torque M on OA
force F at C along y
find k = M/F
""",
    "parallelogram_of_three_cranks": """
pivot O at (0 mm, 0 mm)
pivot Q at (100 mm, 0 mm)
pivot R at (200 mm, 0 mm)
link OA
link QB
link RC
link ABC
A at (30 mm, 40 mm)
B at (130 mm, 40 mm)
C at (230 mm, 40 mm)
drive OA from 20 deg to 80 deg
torque M on OA
torque T on RC
find k = M/T
""",
    "toggle_clamp": """
pivot H at (-2.6 m, 1.9 m)
pivot N at (-1.4 m, -0.6 m)
link HE "handle"
link EP
link NP
E at (-0.6 m, 1.5 m)
P at (1.6 m, 0.35 m)
drive HE from -20 deg to 5 deg
torque M on HE
force F at P along -y
find k = M/F
""",
    "trammel": """
pivot O at (0 mm, 0 mm)
slider S along x through O
slider T along y through O
link ST
S at (60 mm, 0 mm)
T at (0 mm, 80 mm)
drive ST from 100 deg to 170 deg
force P at S along x
force F at T along y
find k = P/F
""",
    "scotch_yoke": """
pivot A at (0 m, 0 m)
link AB
slide CDE along x
slot B in CD
B at (0.6 m, 0.8 m)
C at (0.6 m, -1.9 m)
D at (0.6 m, 1.9 m)
E at (4.6 m, 0 m)
drive AB from 20 deg to 160 deg
torque M on AB
force F at E along x
find k = M/F
""",
    "gripper_with_a_mirror": """
pivot O at (20 mm, 0 mm)
slider K along y
link KA
link OAJ
K at (0 mm, 10 mm)
A at (40 mm, 20 mm)
J at (15 mm, 80 mm)
mirror across y sharing K
force P at K along y
force F at J along x
find k = P/F
""",
    "wedge_and_lever": """
pivot O at (0 mm, 0 mm)
slide WX along x
link OA
contact A on WX normal 100 deg
A at (100 mm, 20 mm)
W at (50 mm, 0 mm)
X at (150 mm, 20 mm)
force P at W along x
force F at A along -y
find k = P/F
""",
    "gears_on_levers": """
pivot O at (0 mm, 0 mm)
pivot Q at (60 mm, 0 mm)
link OA
link QB
gear O 40 mm, Q 20 mm
A at (-10 mm, 100 mm)
B at (75 mm, 90 mm)
drive OA from 80 deg to 100 deg
force P at A along x
force F at B along x
find k = P/F
""",
    "rack_and_lever": """
pivot O at (0 mm, 0 mm)
slider A along y through (30 mm, 0 mm)
link OB
rack A on O 30 mm
A at (30 mm, 20 mm)
B at (-70 mm, 45 mm)
force P at A along y
force F at B along -y
find k = P/F
""",
    "watt_six_bar": """
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
link OA
link ABD
link CBE
link DF
link EF
A at (20 mm, 35 mm)
B at (85 mm, 60 mm)
D at (50 mm, 95 mm)
E at (140 mm, 45 mm)
F at (120 mm, 130 mm)
torque M on OA
force F at D along x
find k = M/F
""",
    "stephenson_six_bar": """
pivot O at (0 mm, 0 mm)
pivot C at (100 mm, 0 mm)
pivot Q at (180 mm, 20 mm)
link OA
link ABD
link CB
link DE
link QE
A at (20 mm, 35 mm)
B at (85 mm, 60 mm)
D at (60 mm, 110 mm)
E at (160 mm, 100 mm)
drive OA from 40 deg to 80 deg
torque M on OA
torque T on QE
find k = M/T
""",
    "two_step_press": """
pivot O at (0 mm, 0 mm)
pivot C at (120 mm, 140 mm)
slider S along y
link OA
link AK
link CK
link KS
A at (35 mm, 30 mm)
K at (130 mm, 60 mm)
S at (118 mm, -40 mm)
drive OA from 10 deg to 70 deg
torque M on OA
force F at S along -y
find k = M/F
""",
    "lever_with_a_spring": """
pivot O at (0 mm, 0 mm)
pivot C at (60 mm, -20 mm)
link OAB
telescope CA
A at (50 mm, 40 mm)
B at (90 mm, 75 mm)
actuator P between C and A
force F at B along -y
find k = P/F
""",
}
