/*---------------------------------------------------------------------------*\
    demPlanStreams.C -- streams through patches that cannot enter, are too dense, or may return.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demPlan.H"
#include "demCheck.H"
#include "dem_numbers.h"
#include <sstream>

namespace Foam
{

// Solid fractions at a face: random free positions fill it to no more than the first, depending on the
// path in a step; to the second in any case
static const scalar most = 0.5, sure = 0.3;


static std::string vectorText(const vector& v)
{
    std::ostringstream text;
    text<< '(' << v.x() << ' ' << v.y() << ' ' << v.z() << ')';
    return text.str();
}


// Velocity [m/s] at which a lone particle leaves the mesh through a patch, with the fluid there
// and its weight less buoyancy; 0 within round-off. gravity [m/s2]: component out of the mesh.
// Collective.
static scalar outwardDrift
(
    const scalar diameter,
    const scalar density,
    const scalar gravity,
    const demFlow& flow,
    const label patchi
)
{
    const fvPatchVectorField& U = flow.U.boundaryField()[patchi];
    const scalarField& magSf = U.patch().magSf();
    const scalar area = gSum(magSf);
    const scalar rho = gSum((magSf*flow.rho.boundaryField()[patchi])())/area;
    const scalar mu = gSum((magSf*flow.mu.boundaryField()[patchi])())/area;
    const scalar fluid = gSum((U & U.patch().Sf())())/area;
    const scalar settles =
        sign((density - rho)*gravity)
       *dem_sphere_terminal_velocity(diameter, density, rho, mu, mag(gravity));
    const scalar drift = fluid + settles;

    return mag(drift) > 1e-6*(mag(fluid) + mag(settles)) ? drift : 0;
}

} // End namespace Foam


// Streams through patches: nothing enters, more is due than there is room for, or particles
// return to the patch. Collective.
void Foam::demPlan::streamWarnings(const demFlow& flow, DynamicList<string>& warnings) const
{
    struct ::dem_scene_numbers scene;
    struct ::dem_stream_info s;
    demCheck(dem_scene_numbers(particles_.core(), &scene));

    for (int k = 0; dem_stream_info(particles_.core(), k, &s); k++)
    {
        const label patchi = s.patch ? mesh_.boundaryMesh().findPatchID(s.patch) : -1;
        if (patchi < 0)
        {
            continue;
        }

        const fvPatchVectorField& U = flow.U.boundaryField()[patchi];
        const vectorField& Sf = U.patch().Sf();
        const vectorField normal(U.patch().nf());
        const scalarField& magSf = U.patch().magSf();
        const vector given(s.velocity[0], s.velocity[1], s.velocity[2]);
        const vector spread(s.spread[0], s.spread[1], s.spread[2]);
        const vectorField velocity(s.with_fluid ? vectorField(U) : vectorField(U.size(), given));

        const scalar area = gSum(magSf);
        const vector outward(gSum(Sf)/area);
        const scalar inflow = gSum(max(-(velocity & Sf), scalar(0))());
        const scalarField fastest((spread & cmptMag(normal)) - (velocity & normal));
        const std::string entry(std::string("insert/") + s.name);

        // a fluid velocity that may change says nothing
        const bool lasts = !s.with_fluid || U.type() == "fixedValue";

        if (lasts && gMax(fastest) <= 0)
        {
            std::ostringstream text;
            text<< entry << ": nothing enters through patch " << s.patch << ", as velocity "
                << (s.with_fluid ? "fluid " : "") << vectorText(gSum((magSf*velocity)())/area)
                << " m/s does not point into the mesh; give one with a component along "
                << vectorText(vector(Zero) - outward)
                << (s.with_fluid ? ", here or for the fluid in 0/U" : "");
            warnings.append(text.str());
            continue;
        }

        const scalar fraction = inflow > 0 ? s.volume_rate/inflow : 0;
        if (lasts && fraction > most)
        {
            const scalar speed = inflow/gSum((magSf*pos(-(velocity & Sf)))());
            std::ostringstream text;
            text<< entry << ": " << s.volume_rate << " m3/s of particles through patch " << s.patch
                << " at " << speed << " m/s have a solid fraction of " << fraction << ", above "
                << most << ", so not all find free space; give "
                << (s.by_mass ? "a massRate" : "a rate") << " of at most "
                << s.rate*sure/fraction << (s.by_mass ? " kg/s" : " 1/s")
                << ", or a velocity of at least " << speed*fraction/sure << " m/s";
            warnings.append(text.str());
        }

        if (!scene.drag_law || particles_.inletsOutlets().outlets().found(patchi))
        {
            continue;
        }

        const scalar gravity = particles_.gravity() & outward;
        for (const scalar d : {s.max_diameter, s.min_diameter})
        {
            const scalar drift = outwardDrift(d, s.density, gravity, flow, patchi);
            if (drift > 0)
            {
                std::ostringstream text;
                text<< entry << ": particles may return to patch " << s.patch << ", which ends the"
                    << " run: one of " << d << " m drifts out of the mesh at " << drift
                    << " m/s in the fluid there now; add outlets { back { patch " << s.patch
                    << "; } }";
                warnings.append(text.str());
                break;
            }
        }
    }
}
