/*---------------------------------------------------------------------------*\
    demPlanBaffles.C -- warns of baffles through which kernels reach.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demPlan.H"
#include "demRankBuffers.H"
#include "globalIndex.H"
#include "labelIOList.H"
#include <algorithm>
#include <utility>
#include <vector>

namespace Foam
{

// Points of the faces of patches, in ascending order, and the patches. Points have their numbers in the
// mesh before its decomposition, and faces with the same points are on the same rank. Collective.
static std::vector<std::pair<std::vector<label>, label>> patchFaces(const polyMesh& mesh)
{
    const labelIOList whole
    (
        IOobject
        (
            "pointProcAddressing",
            mesh.facesInstance(),
            polyMesh::meshSubDir,
            mesh,
            IOobject::READ_IF_PRESENT,
            IOobject::NO_WRITE,
            false
        )
    );
    const globalIndex numbers(mesh.nPoints());
    const bool known = returnReduce(whole.size() == mesh.nPoints(), andOp<bool>());
    demRankBuffers out(Pstream::nProcs());
    demRankBuffers in(Pstream::nProcs());

    forAll(mesh.boundaryMesh(), patchi)
    {
        for (const face& f : static_cast<const faceList::subList&>(mesh.boundaryMesh()[patchi]))
        {
            labelList points(f);
            for (label& pointi : points)
            {
                pointi = known ? whole[pointi] : numbers.toGlobal(pointi);
            }
            sort(points);

            DynamicList<scalar>& message = out[points[0] % Pstream::nProcs()];
            message.append(patchi < mesh.boundaryMesh().nNonProcessor() ? patchi : -1);
            message.append(points.size());
            for (const label pointi : points)
            {
                message.append(pointi);
            }
        }
    }
    demExchangeBuffers(out, in);

    std::vector<std::pair<std::vector<label>, label>> faces;
    for (const DynamicList<scalar>& message : in)
    {
        for (label k = 0; k < message.size(); k += 2 + label(message[k + 1]))
        {
            const scalar* points = &message[k + 1] + 1;
            faces.emplace_back
            (
                std::vector<label>(points, points + label(message[k + 1])), label(message[k])
            );
        }
    }
    std::sort(faces.begin(), faces.end());
    return faces;
}

} // End namespace Foam


// Baffles as createBaffles makes them: both sides have the same points, and kernels with weights at
// points reach from one to the other. Collective.
void Foam::demPlan::baffleWarning(DynamicList<string>& warnings) const
{
    const polyBoundaryMesh& patches = mesh_.boundaryMesh();
    labelList sides(patches.nNonProcessor(), Zero);
    const auto faces(patchFaces(mesh_));

    for (size_t from = 0, to = 0; from < faces.size(); from = to)
    {
        bool passes = false;

        for (; to < faces.size() && faces[to].first == faces[from].first; ++to)
        {
            passes = passes || faces[to].second < 0 || patches[faces[to].second].coupled();
        }
        for (size_t k = from; k < to && to > from + 1 && !passes; ++k)
        {
            sides[faces[k].second]++;
        }
    }

    string names;
    label n = 0;
    forAll(sides, patchi)
    {
        reduce(sides[patchi], sumOp<label>());
        if (sides[patchi] > 0)
        {
            names += (n ? ", " : "") + patches[patchi].name();
            n += sides[patchi];
        }
    }
    if (n)
    {
        warnings.append
        (
            "patch " + names + ": both sides of a baffle share their points (" + name(n/2) + " faces), so"
            " kernels except divided and particleCentre reach through it; run mergeOrSplitBaffles -split -overwrite"
        );
    }
}
