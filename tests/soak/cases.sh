# cases.sh -- the cases of ./run: make_NAME leaves a mesh and says which solver runs it, check_NAME compares a number.
#
# A stock case is a tutorial (FOAM_TUTORIALS), copied and meshed as in its own Allrun, with the files of ./NAME on top:
# constant/demProperties, and for demPimpleFoam the files that solver reads, as docs/coupled-case.md describes.
# Cases without a stock name are ours; all of their files are in ./NAME or written here.
#
# SPDX-License-Identifier: GPL-3.0-or-later

# ---- tools ------------------------------------------------------------------------------------------------------

# stock PATH: a copy of the stock case with our files, in $work/$case
stock()
{
    [ -d "$FOAM_TUTORIALS/$1" ] || { echo "#   FOAM_TUTORIALS has no $1"; return 1; }
    cp -r "$FOAM_TUTORIALS/$1" "$work/$case" && chmod -R u+w "$work/$case" && cp -r "$here/$case/." "$work/$case" &&
        cd "$work/$case" || return 1
    [ ! -d 0.orig ] || [ -d 0 ] || cp -r 0.orig 0
}

# ours: a case of our own, on the files of tests/coupled/shared
ours()
{
    mkdir "$work/$case" && cp -r "$here/../coupled/shared/." "$work/$case" && cp -r "$here/$case/." "$work/$case" && cd "$work/$case" &&
        cp -r 0.orig 0
}

# control TEXT ...: entries at the end of controlDict, which replace earlier ones
control()
{
    printf '%s\n' "$@" >> system/controlDict
}

function_object='functions { particles { type demCloud; libs ("libdemCoupling.so"); } }'

# header CLASS NAME: the head of a file of OpenFOAM
header()
{
    printf 'FoamFile { version 2.0; format ascii; class %s; object %s; }\n' "$1" "$2"
}

# number WHAT VALUE REFERENCE SHARE: the case's checked number, for the table
number()
{
    checked="$1,$2,$3"
    claim "$case: $1 is $2, by reference $3 (share $4)" near "$2" "$3" "$4"
}

# time_of FOLDER: the last time that was written there
time_of()
{
    find "$1" -maxdepth 1 -name '[0-9]*' -exec basename {} \; | sort -g | tail -n 1
}

# state [TIME]: x y z ux uy uz of all particles, of all ranks, at that time or the last
state()
{
    local folder time
    for folder in $(find . -maxdepth 1 -name 'processor*' | grep . || echo .)
    do
        time=${1:-$(time_of "$folder")}
        paste <(values "$folder/$time/lagrangian/particles/positions") <(values "$folder/$time/lagrangian/particles/U") |
            awk 'NF >= 6 { print $1, $2, $3, $(NF - 2), $(NF - 1), $NF }'
    done
}

# flow NAME COLUMN: a number of the last row of a stream or outlet in the table of flows, by the column's head
flow()
{
    awk -F, -v name="$1" -v head="$2" '/^#/ { next } !c { for (k = 1; k <= NF; k++) if (index($k, head) == 1 && !c) c = k }
        c && $2 == name { v = $c } END { print v + 0 }' postProcessing/dem/*/flows.csv
}

# terminal D RHO_P RHO MU: the speed at which a sphere settles by the law of Schiller and Naumann
terminal()
{
    awk -v d="$1" -v s="$2" -v f="$3" -v mu="$4" 'BEGIN { v = 1; for (n = 0; n < 500; n++) {
        Re = f*d*v/mu; v = 0.5*v + 0.5*(s - f)*9.81*d*d/(18*mu*(1 + 0.15*exp(0.687*log(Re)))) } print v }'
}

# entered_rate NAME FACTOR: mass that the stream has brought per second of its time, times a factor
entered_rate()
{
    awk -F, -v name="$1" -v f="$2" '/^#/ { next } !c { for (k = 1; k <= NF; k++) { if ($k ~ /^mass\[/) c = k } next }
        $2 == name { v = f*$c/$1 } END { print v + 0 }' postProcessing/dem/*/flows.csv
}

# mean COLUMN CONDITION: of the rows of state that fulfil it
mean()
{
    awk -v c="$1" "($2) { s += \$c; n++ } END { print (n ? s/n : \"none\") }"
}

# flow_time: the time of the last row of the table of flows
flow_time()
{
    tail -n 1 postProcessing/dem/*/flows.csv | cut -d, -f1
}

# wall_impulse COLUMN: of all walls, from the means of the record
wall_impulse()
{
    awk -F, -v c="$1" '/^#/ || !($1 + 0) { next } $1 != t { before = t; t = $1 } { s += $c*(t - before) }
        END { print NR ? s : "none" }' postProcessing/dem/*/walls.csv
}

# wall_force COLUMN: mean over the last fifth of the record, of all walls together; columns 3, 4, 5 are x, y, z
wall_force()
{
    awk -F, -v c="$1" '/^#/ || !($1 + 0) { next } $1 != t { n++; t = $1 } { f[n] += $c }
        END { for (k = int(0.8*n) + 1; k <= n; k++) { s += f[k]; m++ } print (m ? s/m : "none") }' postProcessing/dem/*/walls.csv
}

# ---- stock cases --------------------------------------------------------------------------------------------------

make_TJunction()
{
    stock incompressible/pimpleFoam/RAS/TJunction && solve blockMesh && solver=pimpleFoam end=1.5 &&
        control "$function_object" "endTime $end; writeInterval 0.5;"
}
# 1 g/s of beads of 0.3 mm
check_TJunction() { number "feed [g/s]" "$(entered_rate feed 1e3)" 1 0.002; }

# the stock mesh with half the cells to a side
make_cyclone()
{
    stock lagrangian/MPPICFoam/cyclone && cp "$FOAM_TUTORIALS/resources/geometry/cyclone.stl.gz" constant/triSurface &&
        sed -i 's/(33 33 63)/(22 22 42)/' system/blockMeshDict && solve blockMesh && solve snappyHexMesh -overwrite &&
        solver=demPimpleFoam end=1.2 && control "endTime $end; writeInterval 0.1;"
}
# Grains of 8 mm are two orders of magnitude above the cut size of such a cyclone (some tens of micrometres by Lapple): all stay
check_cyclone() { number "fraction of the grains that stay" "$(awk -v i="$(flow feed particles)" -v o="$(flow out particles)" 'BEGIN { print 1 - o/i }')" 1 0.01; }

# Particles of 8 mm, denser than water, rest at the bottom at last: walls carry their weight less Archimedes' force
make_damBreak()
{
    stock multiphase/interFoam/laminar/damBreak/damBreak && solve blockMesh && solve setFields && solver=interFoam end=10 &&
        control "$function_object" "endTime $end; writeInterval 1;"
}
check_damBreak()
{
    number "weight on the walls [N]" "$(wall_force 4)" "$(awk 'BEGIN { print -320*200*9.81*16*atan2(1, 1)/3*4e-3^3 }')" 0.05
}

make_mixerVesselAMI2D()
{
    stock incompressible/pimpleFoam/laminar/mixerVesselAMI2D && solve bash ./makeMesh && solver=pimpleFoam end=0.5 &&
        control "$function_object" "endTime $end; writeInterval 0.1; writeFormat ascii;"
}

# Beads just upstream of a propeller, in a rotating zone with sliding interfaces, on a coarser mesh than the stock one. Blades hit
# them in the end
make_propeller()
{
    stock incompressible/pimpleFoam/RAS/propeller && cp "$FOAM_TUTORIALS"/resources/geometry/propellerTip.obj.gz constant/triSurface &&
        sed -i 's/(12 20 12)/(8 14 8)/' system/blockMeshDict && sed -i '/^functions/,/^}/d' system/controlDict &&
        solve blockMesh && solve surfaceFeatureExtract && solve snappyHexMesh -overwrite && rm -rf 0 &&
        solve topoSet -dict system/createInletOutletSets.topoSetDict && solve createPatch -overwrite && rm -rf 0 && cp -r 0.orig 0 &&
        solver=pimpleFoam end=0.009 && control "$function_object" "endTime $end; writeControl adjustable; writeInterval 0.001; writeFormat ascii;"
}
check_propeller()
{
    claim "propeller: blades have hit beads" below 0.02 "$(worst 'overlap at most' log.solver)"
    number "feed [1/s]" "$(flow feed particles | awk -v t="$(flow_time)" '{ print $1/t }')" 20000 0.02
}

make_pitzDaily()
{
    stock incompressible/simpleFoam/pitzDaily && solve blockMesh && solver=simpleFoam end=2000 &&
        sed -i '/^functions/,/^}/d' system/controlDict && sed -i '/residualControl/,/}/d' system/fvSolution &&
        control "$function_object" "endTime $end; writeInterval 500;"
}
# beads enter with the velocity of the fluid and weigh too much to change it before the step
check_pitzDaily() { number "mean velocity before the step [m/s]" "$(state | mean 4 '$1 < 0')" 10 0.02; }

# large eddies, with the time step of the stock case; a tenth of its time
make_pitzDailyPimple()
{
    stock incompressible/pisoFoam/LES/pitzDaily && solve blockMesh && solver=pimpleFoam end=0.01 &&
        sed -i '/^functions/,/^}/d' system/controlDict && sed -i 's/^PISO/PIMPLE/; s/nuTilda|s)"/nuTilda|s).*"/' system/fvSolution &&
        control "$function_object" "endTime $end; writeInterval 1000;"
}
check_pitzDailyPimple() { number "mean velocity before the step [m/s]" "$(state | mean 4 '$1 < 0')" 10 0.02; }

# Balls of foam fall in the room of 5 m through air that is nearly at rest: at 2 s with the speed at which their drag is their weight
make_hotRoom()
{
    stock heatTransfer/buoyantPimpleFoam/hotRoom && solve blockMesh && solve setFields && solver=buoyantPimpleFoam end=4 &&
        control "$function_object" "deltaT 0.05; endTime $end; writeInterval 40;"
}
check_hotRoom() { number "speed of the fall [m/s]" "$(state 2 | mean 5 1 | tr -d -)" "$(terminal 3e-3 30 1.161 1.8e-5)" 0.03; }

# Beads enter with the gas, which enters with 0.1 kg/s; the velocity of the inlet hardly changes in this time
make_angledDuct()
{
    stock compressible/rhoPimpleFoam/RAS/angledDuct && m4 system/blockMeshDict.m4 > system/blockMeshDict && solve blockMesh &&
        echo 'particles { type demMomentumSource; libs ("libdemCoupling.so"); }' >> constant/fvOptions &&
        solver=rhoPimpleFoam end=0.01 && control "$function_object" "deltaT 1e-4; endTime $end; writeInterval 0.01;" &&
        echo 'PIMPLE { nOuterCorrectors 4; }' >> system/fvSolution
}
check_angledDuct()
{
    number "velocity of entering beads [m/s]" "$(awk -v p="$(flow feed px)" -v m="$(flow feed mass)" 'BEGIN { print p/m }')" \
        "$(sed -n '/^ *inlet/,/}/s/.*value *uniform (\([^ ]*\).*/\1/p' 0.01/U)" 0.05
}

# DPMFoam's bed with the files of tutorials/goldschmidt, which falls on the plate; a fiftieth of its time
make_Goldschmidt()
{
    local file
    cp -r "$FOAM_TUTORIALS/lagrangian/DPMFoam/Goldschmidt" "$work/$case" && chmod -R u+w "$work/$case" && cd "$work/$case" || return 1
    for file in controlDict fvSchemes fvSolution; do mv system/$file system/$file.stock; done
    cp -r "$here/../../tutorials/goldschmidt/added/suna/." . &&
        { echo positions; sed -n '/^(/,/^)/p' constant/kinematicCloudPositions; echo ';'; } > constant/positions &&
        echo 'coupling { record { interval 1e-3; } }' > constant/options && solve blockMesh && solver=demPimpleFoam end=0.1 &&
        echo "endTime $end; deltaT 2e-4; writeInterval 0.1; writeFormat ascii;" > system/options
}
# what gas and walls give to the particles is their weight less Archimedes' force, and the momentum that they have
check_Goldschmidt()
{
    number "impulse of gas and walls [Ns]" "$(awk -v w="$(wall_impulse 5)" '!/^#/ { s += 1.2*$2*0.015*0.15*2e-4 } END { print s - w }' \
        postProcessing/plate/0/surfaceFieldValue.dat)" \
        "$(state | awk '{ s += $6; n++ } END { v = 4*atan2(1, 1)/6*0.0025^3; print n*v*((2526 - 1.2)*9.81*0.1 + 2526*s/n) }')" 0.02
}

# ---- refused ------------------------------------------------------------------------------------------------------

make_mixerVessel2D()
{
    stock incompressible/simpleFoam/mixerVessel2D && solve bash ./makeMesh && solver=simpleFoam && control "$function_object" &&
        refusal='Patch rotor rotates with zone MRF1 of constant/MRFProperties and is no surface of revolution'
}

make_oscillatingInletPeriodicAMI2D()
{
    stock incompressible/pimpleFoam/RAS/oscillatingInletPeriodicAMI2D && solve blockMesh && solver=pimpleFoam && control "$function_object" &&
        refusal='patch ami1 is of type cyclicPeriodicAMI, but of the sliding interfaces particles pass cyclicAMI only'
}

# ---- ours ---------------------------------------------------------------------------------------------------------

# grains fall into the open hopper of a stock case, which is kept full, and leave it
make_hopper()
{
    stock lagrangian/icoUncoupledKinematicParcelFoam/hopper/hopperEmptying && solve blockMesh &&
        solver='icoUncoupledKinematicParcelFoam -cloud idle' end=4 &&
        control "$function_object" "deltaT 2e-4; endTime $end; writeInterval 1;"
}
# Beverloo's rule for a slot B wide and L deep, in diameters k = 1.4 less at the edges: 1.03 rho_b sqrt(g) L (B - k d)^1.5. Grains a
# layer deep fill 0.55 of the space between the panes
check_hopper()
{
    number "discharge [g/s]" "$(flow out mass | awk -v t="$(flow_time)" '{ print 1e3*$1/t }')" \
        "$(awk 'BEGIN { print 1e3*1.03*964*0.55*sqrt(9.81)*6.2e-3*exp(1.5*log(0.03 - 1.4*6e-3)) }')" 0.4
}

# The flow is the stock case's before its first iteration, 20 m/s past and into the bike, and frozen: it presses the grains
# on the bike. (simpleFoam does not converge on this mesh, with or without particles.)
make_motorBike()
{
    stock incompressible/simpleFoam/motorBike && cp "$FOAM_TUTORIALS/resources/geometry/motorBike.obj.gz" constant/triSurface &&
        cp "$here/hopper/constant/idleProperties" constant &&
        sed -i 's/^addLayers .*/addLayers false;/' system/snappyHexMeshDict &&
        sed -i '/^functions/,/^}/d' system/controlDict &&
        solve surfaceFeatureExtract && solve blockMesh && solve snappyHexMesh -overwrite && rm -rf 0 && cp -r 0.orig 0 &&
        echo 'ddtSchemes { default Euler; }' >> system/fvSchemes && echo 'rhoInf 1.2;' >> constant/transportProperties &&
        { header dictionary turbulenceProperties; echo 'simulationType laminar;'; } > constant/turbulenceProperties &&
        { header uniformDimensionedVectorField g; echo 'dimensions [0 1 -2 0 0 0 0]; value (0 0 -9.81);'; } > constant/g &&
        solver='icoUncoupledKinematicParcelFoam -cloud idle' end=1 &&
        control "$function_object" "deltaT 1e-3; endTime $end; writeControl timeStep; writeInterval 250; writeFormat ascii;"
}
check_motorBike() { number "feed [1/s]" "$(flow hail particles | awk -v t="$(flow_time)" '{ print $1/t }')" 4000 0.01; }

# a bend of a quarter of a circle with swirl at its inlet
make_bend()
{
    ours && solve blockMesh && solver=pimpleFoam end=0.3 && control "$function_object" "endTime $end; writeInterval 0.1;"
}
check_bend() { number "feed [g/s]" "$(entered_rate feed 1e3)" 10 0.01; }

# Grains of 20 mm fall on a ball in a closed box, a mesh of snappyHexMesh. All impulse of the walls is weight less momentum:
# nothing else acts on them
make_sphereInBox()
{
    mkdir "$work/$case" && cp -r "$here/../coupled/shared/." "$here/../coupled/warped/." "$here/$case/." "$work/$case" && cd "$work/$case" &&
        cp -r 0.orig 0 &&
        echo 'body { type searchableSphere; centre (0.05 0.02 -0.03); radius 0.55; }' > system/geometry && echo 'inside (0.8 0.8 0.8);' > system/inside &&
        solve blockMesh && solve snappyHexMesh -overwrite && solver=icoFoam end=1 &&
        control "deltaT 0.01; endTime $end; writeInterval 100;"
}
check_sphereInBox()
{
    local mass
    mass=$(awk 'BEGIN { print 3000*1000*4*atan2(1, 1)/6*0.02^3 }')
    number "impulse of the walls [Ns]" "$(wall_impulse 5)" \
        "$(state | awk -v m="$mass" '{ s += $6; n++ } END { print (n == 3000 ? -(m*s/n + m*9.81) : "none") }')" 0.001
}

# A bed all around the axis of a sector of 5 degrees is settled, then gas of 0.25 m/s goes through it
make_wedgeBed()
{
    ours && solve blockMesh && solve demPimpleFoam -settle && solver=demPimpleFoam end=0.05 && control "endTime $end; writeInterval 0.05;"
}
# Ergun's gradient at void fraction and flux of each cell, over the section, from 3 to 9 mm above the floor
check_wedgeBed()
{
    local section='{ k = int((NR - 1)/6); w = (2*((NR - 1)%6) + 1)/36 }'
    number "pressure drop of 6 mm [Pa]" "$(values 0.05/p | awk "$section"' { p[k] += w*$1 } END { print 1.2*(p[1] - p[4]) }')" \
        "$(paste <(values 0.05/voidFraction) <(values 0.05/U) | awk "$section"' { e = $1; u = e*$4
            g[k] += w*(150*(1 - e)^2/e^3*1.8e-5*u/1e-6 + 1.75*(1 - e)/e^3*1.2*u*u/1e-3) }
            END { print 0.002*(g[1]/2 + g[2] + g[3] + g[4]/2) }')" 0.03
    claim "$case: the flux goes through (1 %)" near "$(paste <(values 0.05/voidFraction) <(values 0.05/U) |
        awk "$section"' k == 2 { f += w*$1*$4 } END { print f }')" 0.25 0.01
}

# Grains that enter a channel at 2 m/s are carried along by gas of 20 m/s, kEpsilon
make_conveying()
{
    ours && solve blockMesh && solver=pimpleFoam end=0.3 && control "endTime $end; writeInterval 0.1;" "$function_object"
}
# velocity of a grain of 1 mm and 1000 kg/m3 after 0.425 m, by Schiller and Naumann's drag alone
check_conveying()
{
    number "velocity after 0.4 m [m/s]" "$(state | mean 4 '$1 > 0.4 && $1 < 0.5')" "$(awk 'BEGIN { v = 2; x = 0; h = 1e-5; while (x < 0.425) {
        u = 20 - v; Re = u*1e-3/1.5e-5; v += h*18*1.8e-5/(1000*1e-6)*(1 + 0.15*exp(0.687*log(Re)))*u; x += h*v } print v }')" 0.05
}

# A hopper, closed above, with a slot of 24 mm by 12 mm over a channel with gas of 25 m/s, which carries the grains away
make_hopperStream()
{
    ours && solve blockMesh && solver=demPimpleFoam end=0.6 && control "endTime $end; writeInterval 0.3;"
}
# Beverloo's law as above, grains of 3 mm at a solid fraction of 0.6. The slot is four grains long, so its ends count like its
# edges: (B - k d)^1.5 (L - k d), 42.1 g/s. While a tenth to a half of the grains is out of the hopper
check_hopperStream()
{
    number "discharge [g/s]" "$(discharge)" "$(awk 'BEGIN { print 1e3*1.03*1000*0.6*sqrt(9.81)*(0.012 - 1.4*3e-3)*exp(1.5*log(0.024 - 1.4*3e-3)) }')" 0.15
}

# rate at which mass passes the height of the slot, from the positions of the record
discharge()
{
    "${SUNA_PYTHON:-python3}" - << 'END'
import struct, glob
data = open(glob.glob('postProcessing/dem/*/particles.bin')[0], 'rb').read()
at, rows = 0, []
while at < len(data):
    time, n = struct.unpack_from('<dq', data, at)
    at += 16
    inside = sum(1 for k in range(n) if struct.unpack_from('<f', data, at + 32*k + 8)[0] > 0.04)
    rows.append((time, inside))
    at += 32*n
first = rows[0][1]
a = next((r for r in rows if r[1] < 0.9*first), None)
b = next((r for r in rows if r[1] < 0.5*first), None)
print(1e6*3.14159265/6*3e-3**3*(a[1] - b[1])/(b[0] - a[0]) if a and b else 'none')
END
}

# A closed drum with grains, in which two crossed paddles, a surface, turn once a second
make_drum()
{
    ours && solve blockMesh && solver=demPimpleFoam end=2 && control "endTime $end; writeInterval 1;"
}
# all walls together carry the weight, less Archimedes' force
check_drum()
{
    number "force on the walls [mN]" "$(wall_force 4 | awk '{ print 1e3*$1 }')" \
        "$(awk 'BEGIN { print -1e3*2400*(1200 - 1.2)*9.81*4*atan2(1, 1)/6*2e-3^3 }')" 0.02
}

# Geometry and numbers of the ErgunTestMPI of CFDEMcoupling: 10000 spheres of 1 mm and 2000 kg/m3 in a pipe of 13.8 mm radius, fluid of
# 10 kg/m3 and 1.5e-4 m2/s; superficial velocities of 2, 4 and 6 mm/s for 20 ms each, then 20 mm/s, above minimum fluidisation
make_Ergun()
{
    ours && solve blockMesh && solve demPimpleFoam -settle && solver=demPimpleFoam end=0.2 && control "endTime $end; writeInterval 0.02;"
}
# In the bed's middle, between the centres of the second and fifth layer of cells (2.304 mm), Ergun's gradient at 6 mm/s with the solid
# fraction of the spheres there; at last the whole drop is the weight
check_Ergun()
{
    local area
    area=$(awk 'BEGIN { print 4*atan2(1, 1)*0.0138^2 }')
    number "pressure drop of 6.9 mm at 6 mm/s [Pa]" "$(values 0.06/p | awk 'NR == 64 + 28 { a = $1 } NR == 4*64 + 28 { print 10*(a - $1) }')" \
        "$(state 0.06 | awk -v A="$area" '$3 > 0.003456 && $3 < 0.010369 { n++ } END { h = 0.0069125; s = n*4*atan2(1, 1)/6*1e-9/(A*h); e = 1 - s
            print h*(150*s*s/e^3*1.5e-3*0.006/1e-6 + 1.75*s/e^3*10*0.006^2/1e-3) }')" 0.1
    claim "Ergun: at 20 mm/s the drop is the weight less Archimedes' force per area (5 %)" near \
        "$(awk '$1 > 0.15 { p += $2; n++ } END { print (n ? 10*p/n : "none") }' postProcessing/drop/0/surfaceFieldValue.dat)" \
        "$(awk -v A="$area" 'BEGIN { print 10000*4*atan2(1, 1)/6*1e-9*1990*9.81/A }')" 0.05
}
