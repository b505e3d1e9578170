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

    setFluid(U, gradP, rho, mu);
    demCheck(dem_plan(dem_, &ahead, &text));
    Info<< nl << text << endl;
    warn(U, ahead);
}

// ************************************************************************* //
