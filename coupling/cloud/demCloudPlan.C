/*---------------------------------------------------------------------------*\
    demCloudPlan.C -- plan of a run: passes the state of the fluid and the size of
    the mesh to the core, and prints its report of effects, time steps and cost.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demCloud.H"
#include "demCheck.H"
#include "gaussGrad.H"

// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

// Mean cross-section of the mesh normal to gravity, the area of a bed [m2]
Foam::scalar Foam::demCloud::crossSection() const
{
    const scalar g = mag(gravity());
    const scalar height =
        g > 0 ? mag(mesh_.bounds().span() & gravity())/g : 0;

    return height > 0 ? gSum(mesh_.V().field())/height/transfer_.fraction() : 0;
}


// Void fraction below which half of the particles' volume lies [1]. Unlike the mean
// it is that inside a bed, hardly changed by the surfaces over which the kernel
// spreads them. 1 without particles.
Foam::scalar Foam::demCloud::bedVoidFraction() const
{
    const scalarField& e = voidFraction_.primitiveField();
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


// What the width of the kernel takes from the drag of a bed of this void fraction
void Foam::demCloud::planKernel(const scalar bed) const
{
    const scalar layer = transfer_.surfaceLayer();
    const scalar section = crossSection();

    if (!twoWay_ || layer <= 0 || section <= 0 || bed > DEM_BED_VOID_FRACTION)
    {
        return;
    }

    const scalar volume =
        gSum((mesh_.V().field()*(1 - voidFraction_.primitiveField()))())
       /transfer_.fraction();
    const scalar height = volume/section/(1 - bed);
    const label percent = label(100*min(layer/height, scalar(1)) + 0.5);

    Info<< "Kernel" << nl << "    a bed of " << height << " m with a free surface lacks the"
        << " drag of a layer of " << layer << " m: " << percent
        << " % of its pressure drop while it rests";
    if (percent > 5)
    {
        Info<< "; take kernel linear, or a smaller width or cells";
    }
    Info<< nl << endl;
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demCloud::plan
(
    const volVectorField& U,
    const volVectorField& gradP,
    const volScalarField& rho,
    const volScalarField& mu,
    const string& limit
)
{
    const Time& time = mesh_.time();
    const char* text = nullptr;

    struct dem_run_info ahead = {};
    ahead.window = interval_ > 0 ? interval_ : time.deltaTValue();
    ahead.duration =
        (time.endTime().value() - time.value())/time.deltaTValue()*ahead.window;
    ahead.why = limit.c_str();
    ahead.cross_section = crossSection();
    ahead.volume = gSum(mesh_.V().field())/transfer_.fraction();
    ahead.cell = cbrt(gMin(mesh_.V().field()));
    ahead.speed = gMax(mag(U.primitiveField()));

    // With a fixed scheme: fvSchemes of the case may give none for grad(U)
    const volTensorField gradU(fv::gaussGrad<vector>(mesh_).calcGrad(U, "dem:gradU"));
    ahead.vorticity = 2*gMax(mag(skew(gradU.primitiveField()))()/sqrt(scalar(2)));
    ahead.one_way = !twoWay_;
    ahead.void_fraction = bedVoidFraction();

    setFluid(U, gradP, rho, mu);
    demCheck(dem_plan(dem_, &ahead, &text));
    Info<< nl << text << endl;
    planKernel(ahead.void_fraction);
    warn(U, ahead);
}

// ************************************************************************* //
