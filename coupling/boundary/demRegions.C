/*---------------------------------------------------------------------------*\
    demRegions.C -- surfaces of the mesh and of its zones, for the groups of insert.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRegions.H"
#include "demCheck.H"
#include "demDomain.H"
#include "demWedge.H"
#include "DynamicList.H"
#include "processorCyclicPolyPatch.H"
#include "syncTools.H"

namespace Foam
{

// Between ranks: inside the mesh
static bool isCut(const polyPatch& patch)
{
    return isA<processorPolyPatch>(patch) && !isA<processorCyclicPolyPatch>(patch);
}


// A fan from the first point, which a reversed face keeps
static void appendFan
(
    const face& f,
    const bool reversed,
    const pointField& points,
    DynamicList<double>& corners
)
{
    for (label k = 1; k + 1 < f.size(); k++)
    {
        const label at[3] = {f[0], f[reversed ? k + 1 : k], f[reversed ? k : k + 1]};

        for (const label pointi : at)
        {
            for (direction c = 0; c < 3; c++)
            {
                corners.append(points[pointi][c]);
            }
        }
    }
}

} // End namespace Foam


Foam::bitSet Foam::demRegions::cells
(
    const word& zone,
    const dictionary& group
) const
{
    const label zonei = mesh_.cellZones().findZoneID(zone);
    bitSet inside(mesh_.nCells());

    if (zonei >= 0)
    {
        inside.set(mesh_.cellZones()[zonei]);
    }

    if (!returnReduce(label(inside.count()), sumOp<label>()))
    {
        demUnknown
        (
            group,
            "insert/" + std::string(group.dictName()),
            "zone of cells",
            zone,
            mesh_.cellZones().names()
        );
    }
    return inside;
}


Foam::List<double> Foam::demRegions::surface(const bitSet& inside) const
{
    const tmp<pointField> tpoints(demDomain::firstPoints(mesh_));
    const faceList& faces = mesh_.faces();
    const labelList& owner = mesh_.faceOwner();
    const labelList& neighbour = mesh_.faceNeighbour();
    DynamicList<double> corners;

    // 1 for the cells inside; across processor faces the other rank's value
    labelList flags(mesh_.nCells());
    labelList across;
    forAll(flags, celli)
    {
        flags[celli] = inside.test(celli);
    }
    syncTools::swapBoundaryCellList(mesh_, flags, across);

    for (label facei = 0; facei < mesh_.nInternalFaces(); facei++)
    {
        const bool ours = flags[owner[facei]];

        if (ours != bool(flags[neighbour[facei]]))
        {
            appendFan(faces[facei], !ours, tpoints(), corners);
        }
    }

    for (const polyPatch& patch : mesh_.boundaryMesh())
    {
        const bool cut = isCut(patch);

        for (label facei = patch.start(); facei < patch.start() + patch.size(); facei++)
        {
            if
            (
                flags[owner[facei]]
             && !(cut && across[facei - mesh_.nInternalFaces()])
            )
            {
                appendFan(faces[facei], false, tpoints(), corners);
            }
        }
    }

    List<double> all;
    all.transfer(corners);
    return all;
}


void Foam::demRegions::add
(
    ::dem_case* c,
    const word& name,
    const bool zone,
    const bitSet& inside
) const
{
    const List<double> corners(surface(inside));

    demCheck
    (
        dem_case_add_region
        (
            c,
            name.c_str(),
            zone,
            corners.size()/9,
            corners.cdata()
        )
    );
}


Foam::demRegions::demRegions(const polyMesh& mesh, const demDict& dict)
:
    mesh_(mesh),
    dict_(dict)
{}


void Foam::demRegions::add(::dem_case* c) const
{
    wordHashSet added;
    bool whole = false;

    for (const entry& e : dict_.scene().subOrEmptyDict("insert"))
    {
        const dictionary& group = e.isDict() ? e.dict() : dictionary::null;
        const bool mesh = group.getOrDefault<word>("inside", word::null) == "mesh";
        const word zone(group.getOrDefault<word>("zone", word::null));

        if ((mesh || !zone.empty()) && demWedge::is(mesh_))
        {
            FatalIOErrorInFunction(group)
                << "insert/" << e.keyword() << ": the mesh is a wedge, but the"
                << " particles fill the whole circle; give a cylinder, and inside"
                << " walls, instead of inside mesh or a zone"
                << exit(FatalIOError);
        }
        if (mesh && !whole)
        {
            add(c, "mesh", false, bitSet(mesh_.nCells(), true));
            whole = true;
        }
        if (!zone.empty() && added.insert(zone))
        {
            add(c, zone, true, cells(zone, group));
        }
    }
}
