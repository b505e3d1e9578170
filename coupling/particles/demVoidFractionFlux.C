/*---------------------------------------------------------------------------*\
    demVoidFractionFlux.C -- the volume flux of the particles for the continuity
    equation (averaged/voidageFlux.H): between cells, through patches, and sources
    inside the mesh.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demVoidFraction.H"
#include "demColumns.H"
#include "surfaceFields.H"
#include <algorithm>
#include <utility>
#include <vector>

namespace Foam
{
    // Add the values of particles to their passages, in the order of ids: the order in memory
    // depends on neighbor lists and restarts. -1: no passage
    static void addInOrder
    (
        const demView& view,
        const UList<label>& passage,
        const UList<scalar>& value,
        scalarField& sum
    )
    {
        std::vector<std::pair<int64_t, label>> order;

        forAll(passage, i)
        {
            if (passage[i] >= 0)
            {
                order.emplace_back(idOf(view, i), i);
            }
        }
        std::sort(order.begin(), order.end());
        for (const auto& particle : order)
        {
            sum[passage[particle.second]] += value[particle.second];
        }
    }
}


// `volume` of each particle that the fluid sees [m3]. Its mean velocity is its
// displacement over the step: the velocity at the end of the step alternates
// where light particles pack. Without fluid forces the core has no displacements.
void Foam::demVoidFraction::depositFlux(const UList<scalar>& volume)
{
    vectorField volumeFlux(view_.n);

    forAll(volumeFlux, i)
    {
        volumeFlux[i] =
            volume[i]
           *(
                fluid_.displacement
              ? vectorAt(fluid_.displacement, i)/particles_.window()
              : velocity(view_, i)
            );
    }
    transfer_.deposit(volumeFlux, solidSuperficialVelocity_.ref());
    solidSuperficialVelocity_.correctBoundaryConditions();
}


// Volumes that the fluid sees [m3]; `behind`: by passage, the volume of the particles
// there that it does not see yet or any more, on all ranks [m3]. Collective.
Foam::tmp<Foam::scalarField> Foam::demVoidFraction::reducedVolumes(scalarField& behind) const
{
    tmp<scalarField> tV(new scalarField(volumes(view_)));
    scalarField& V = tV.ref();

    behind.setSize(inletsOutlets_.passages().size());
    behind = 0;
    if (inletsOutlets_.active())
    {
        const scalarField whole(V);
        const labelList passage
        (
            inletsOutlets_.reduceVolumes(transfer_.inMeshFrame(view_), V)
        );
        addInOrder(view_, passage, scalarField(whole - V), behind);
        for (scalar& volume : behind)
        {
            reduce(volume, sumOp<scalar>());
        }
    }
    return tV;
}


// Let streams and outlets act, and book the particle volume that they move through
// patches and create inside the mesh. New particles near an inlet came through it.
void Foam::demVoidFraction::passWithVolumes(const volVectorField& U)
{
    const scalar step = mesh_.time().deltaTValue();
    const bool inside = inletsOutlets_.insideMesh();
    scalarField before, after, behind;

    sources_.clear();
    if (inside)
    {
        if (mesh_.moving())
        {
            particles_.locate();
        }
        transfer_.deposit(reducedVolumes(behind)(), before);
    }
    const int64_t lastId = fluid_.location ? -1 : largestId(view_);
    const bool changed = particles_.passInletsOutlets(U);
    boolList isNew;

    if (changed)
    {
        particles_.refresh();
        isNew.setSize(view_.n);
        forAll(isNew, i)
        {
            isNew[i] =
                fluid_.location ? fluid_.location[2*i] < 0 : idOf(view_, i) > lastId;
        }
        particles_.locateInserted();
    }

    scalarField V(reducedVolumes(behind));
    throughPatches_ = behind;
    if (!changed)
    {
        return;
    }

    const demView view(transfer_.inMeshFrame(view_));
    labelList through(view_.n, -1);
    const scalarField entered(V);
    forAll(isNew, i)
    {
        if (!isNew[i])
        {
            continue;
        }
        const scalar reach =
            2*(*dem_at(view_.radius, view_.stride, size_t(i)))
          + mag(velocity(view_, i))*step;
        through[i] = inletsOutlets_.inletWithin(position(view, i), reach);
        if (through[i] >= 0)
        {
            V[i] = 0;
        }
    }
    addInOrder(view_, through, entered, throughPatches_);
    for (label k = 0; k < throughPatches_.size(); k++)
    {
        throughPatches_[k] =
            behind[k] + returnReduce(throughPatches_[k] - behind[k], sumOp<scalar>());
    }
    if (inside)
    {
        transfer_.deposit(V, after);
        sources_ = (after - before)/step;
    }
}


void Foam::demVoidFraction::addSources(UList<scalar>& cells) const
{
    forAll(sources_, celli)
    {
        cells[celli] += sources_[celli];
    }
}


Foam::tmp<Foam::scalarField> Foam::demVoidFraction::solidPatchFlux(const label patchi) const
{
    const label k = inletsOutlets_.passages().find(patchi);
    const scalarField& area = mesh_.magSf().boundaryField()[patchi];

    tmp<scalarField> tflux(new scalarField(area.size(), Zero));
    if (k >= 0 && k < throughPatches_.size())
    {
        tflux.ref() =
           -throughPatches_[k]/mesh_.time().deltaTValue()*area/gSum(area);
    }
    return tflux;
}
