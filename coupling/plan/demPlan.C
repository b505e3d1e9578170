/*---------------------------------------------------------------------------*\
    demPlan.C -- plan of a run.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demPlan.H"
#include "demCheck.H"
#include "demFluid.H"
#include "gaussGrad.H"

namespace Foam
{

// Volume of the cells between two heights x . up [m3]. A cell counts with the
// fraction of its height that lies in between: exact for cells of constant section.
static scalar volumeBetween
(
    const fvMesh& mesh,
    const vector& up,
    const scalar low,
    const scalar high
)
{
    const scalarField height(mesh.points() & up);
    const labelListList& cellPoints = mesh.cellPoints();
    scalar volume = 0;

    forAll(cellPoints, celli)
    {
        scalar bottom = GREAT, top = -GREAT;
        for (const label pointi : cellPoints[celli])
        {
            bottom = min(bottom, height[pointi]);
            top = max(top, height[pointi]);
        }
        volume += mesh.V()[celli]
           *max(min(top, high) - max(bottom, low), scalar(0))
           /max(top - bottom, VSMALL);
    }
    return returnReduce(volume, sumOp<scalar>());
}

} // End namespace Foam


// Mean cross-section of the mesh over the bed, between the heights below which
// 10 and 90 % of the particles' volume lies [m2]; 0 without a bed
Foam::scalar Foam::demPlan::crossSection() const
{
    double up[3], low, high;

    if (!dem_bed_slab(particles_.core(), up, &low, &high) || high <= low)
    {
        return 0;
    }
    return volumeBetween(mesh_, vector(up[0], up[1], up[2]), low, high)
       /(high - low)/transfer_.fraction();
}


// Fluid that enters against gravity [m3/s]. `varies`: 1 where a patch's condition may
// change it with time.
Foam::scalar Foam::demPlan::inflow(const volVectorField& U, int& varies) const
{
    const vector& down = particles_.gravity();
    scalar flow = 0;
    label changing = 0;

    forAll(U.boundaryField(), patchi)
    {
        const fvPatchVectorField& velocity = U.boundaryField()[patchi];
        const scalarField& e = volume_.voidFractionForFluid().boundaryField()[patchi];
        const vectorField& area = velocity.patch().Sf();
        const label may = velocity.type() != "fixedValue";

        forAll(velocity, facei)
        {
            if (!velocity.coupled() && (velocity[facei] & down) < 0)
            {
                changing = max(changing, may);
                flow += e[facei]*max(-(velocity[facei] & area[facei]), scalar(0));
            }
        }
    }
    varies = returnReduce(changing, maxOp<label>());
    return returnReduce(flow, sumOp<scalar>())/transfer_.fraction();
}


// Void fraction below which half of the particles' volume lies [1]; 1 without particles.
// Unlike the mean it hardly depends on the surface of a bed, over which the kernel
// spreads particles.
Foam::scalar Foam::demPlan::bedVoidFraction() const
{
    const scalarField& e = volume_.voidFraction().primitiveField();
    const scalarField solid(mesh_.V().field()*(1 - e));
    const scalar half = 0.5*gSum(solid);
    scalar low = 0, high = 1;

    for (int k = 0; k < 30 && half > 0; k++)
    {
        const scalar middle = 0.5*(low + high);
        scalar below = 0;
        forAll(e, c)
        {
            below += e[c] <= middle ? solid[c] : 0;
        }
        (returnReduce(below, sumOp<scalar>()) < half ? low : high) = middle;
    }
    return high;
}


// Drag that the width of the kernel removes from a bed of this void fraction and cross-section [m2]
void Foam::demPlan::reportKernel(const scalar bed, const scalar section) const
{
    const scalar layer = transfer_.surfaceLayer();

    if (!particles_.twoWay() || layer <= 0 || section <= 0 || bed > DEM_BED_VOID_FRACTION)
    {
        return;
    }

    const scalar volume =
        gSum((mesh_.V().field()*(1 - volume_.voidFraction().primitiveField()))())
       /transfer_.fraction();
    const scalar height = volume/section/(1 - bed);
    const label percent = label(100*min(layer/height, scalar(1)) + 0.5);

    Info<< "Kernel" << nl << "    a bed of " << height << " m with a free surface lacks the"
        << " drag of a layer of " << layer << " m: " << percent
        << " % of its pressure drop while it rests";
    if (percent > 5)
    {
        Info<< (transfer_.width() > 0
            ? "; take kernel linear, or a smaller width or cells" : "; smaller cells lose less");
    }
    Info<< nl << endl;
}


Foam::demPlan::demPlan(const demParticles& particles, const demVoidFraction& volume)
:
    mesh_(particles.mesh()),
    particles_(particles),
    volume_(volume),
    transfer_(particles.transfer())
{}


void Foam::demPlan::report(const demFlow& flow, const step& fluid)
{
    const volVectorField& U = flow.U;
    const Time& time = mesh_.time();
    const char* text = nullptr;

    struct dem_run_info ahead = {};
    ahead.window = particles_.interval() > 0 ? particles_.interval() : time.deltaTValue();
    ahead.duration =
        (time.endTime().value() - time.value())/time.deltaTValue()*ahead.window;
    ahead.why = fluid.limit.c_str();
    ahead.cross_section = crossSection();
    ahead.inflow =
        ahead.cross_section > 0 ? inflow(U, ahead.inflow_varies)/ahead.cross_section : 0;
    ahead.volume = gSum(mesh_.V().field())/transfer_.fraction();
    ahead.cell = cbrt(gMin(mesh_.V().field()));
    ahead.speed = gMax(mag(U.primitiveField()));

    // With a fixed scheme, as the case's fvSchemes may have none for grad(U)
    const volTensorField gradU(fv::gaussGrad<vector>(mesh_).calcGrad(U, "dem:gradU"));
    ahead.vorticity = 2*gMax(mag(skew(gradU.primitiveField()))()/sqrt(scalar(2)));
    ahead.one_way = !particles_.twoWay();

    // The entering flow has not filled the bed yet; inside the bed it is faster
    const scalar crossing =
        ahead.inflow > 0 && fluid.maxCo > 0
      ? fluid.maxCo*ahead.cell*gMin(volume_.voidFractionForFluid().primitiveField())/ahead.inflow
      : GREAT;
    const string throughflow("maxCo, by the inlet's flow through the bed");
    const scalar longest = min(fluid.reached, crossing);

    // Nothing limits the step in a fluid at rest: it is still growing when the run ends
    const bool reached = longest < time.endTime().value() - time.value();

    if (fluid.reached > 0 && reached && mag(longest - ahead.window) > 0.1*ahead.window)
    {
        ahead.reached_window = longest;
        ahead.reached_why =
            crossing < fluid.reached ? throughflow.c_str() : fluid.reachedBy.c_str();
    }

    demCheck(dem_plan(particles_.core(), &ahead, &text));
    Info<< nl << text << endl;
    if (demFluid::hasPhases(mesh_))
    {
        Info<< "Two fluids" << nl << "    the regime and the laws are judged in the fluid around the"
            << " particles now; where they go into the other one, laws that are negligible here"
            << " may be needed" << nl << endl;
    }
    reportKernel(bedVoidFraction(), ahead.cross_section);
    warn(flow, ahead);
}
