/*---------------------------------------------------------------------------*\
    demForm.C -- the set of equations and the form of the exchange.

    This file is part of Suna, free software under the GNU General Public
    License, version 3 or any later version, without any warranty.
    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demForm.H"
#include "demCheck.H"

// * * * * * * * * * * * * * * * Local Functions * * * * * * * * * * * * * * //

namespace Foam
{

static const wordList sets({"I", "II", "III"});

// In the order of the core's dem_exchange
static const wordList exchanges({"deferred", "semiImplicit", "explicit"});

// The place of the chosen word among those that are known
static label choice
(
    const dictionary& coupling,
    const word& name,
    const wordList& known,
    const word& usual
)
{
    const word given(coupling.getOrDefault<word>(name, usual));
    const label place = known.find(given);

    if (place < 0)
    {
        demUnknown(coupling, "coupling", name.c_str(), given, known);
    }
    return place;
}

} // End namespace Foam


// * * * * * * * * * * * * * Private Member Functions  * * * * * * * * * * * //

void Foam::demForm::checkGiven(const word& name, const bool makesRoom) const
{
    const dictionary& own = dict_.coupling();

    if (own.found(name) && !own.getOrDefault("twoWay", true))
    {
        FatalIOErrorInFunction(own)
            << name << " says how the fluid feels the particles, but with"
            << " twoWay no it does not; take out one of them in coupling of"
            << " constant/" << demDict::name() << exit(FatalIOError);
    }

    if (own.found(name) && !makesRoom)
    {
        FatalIOErrorInFunction(own)
            << name << " is for demPimpleFoam; this solver's own equations know"
            << " no void fraction. Take it out of coupling in constant/"
            << demDict::name() << exit(FatalIOError);
    }
}


// * * * * * * * * * * * * * * * * Constructor * * * * * * * * * * * * * * * //

Foam::demForm::demForm(const demDict& dict, const bool makesRoom)
:
    dict_(dict),
    set_(equations(choice(dict.coupling(), "equations", sets, "II"))),
    exchange_
    (
        ::dem_exchange
        (
            choice(dict.coupling(), "exchange", exchanges, "deferred")
        )
    )
{
    checkGiven("equations", makesRoom);
    checkGiven("exchange", true);
}


// * * * * * * * * * * * * * * * Member Functions  * * * * * * * * * * * * * //

void Foam::demForm::checkEffects() const
{
    if (!dict_.acts("pressureGradient"))
    {
        FatalErrorInFunction
            << "Equations " << sets[set_] << " need pressureGradient {} in"
            << " effects of constant/" << demDict::name() << ": "
            << (
                   set_ == III
                 ? "it carries the particles' buoyancy"
                 : "the fluid leaves them their share of the pressure gradient"
               )
            << ", and without it momentum is lost" << exit(FatalError);
    }

    for (const char* effect : {"virtualMass", "viscousStress"})
    {
        if (set_ == III && dict_.acts(effect))
        {
            FatalErrorInFunction
                << "Equations III are those of a steady, uniform flow, without"
                << " acceleration and stress, and " << effect << " is of one"
                << " that is neither: take equations I or II in coupling of"
                << " constant/" << demDict::name() << ", or leave " << effect
                << " out" << exit(FatalError);
        }
    }
}

// ************************************************************************* //
