/*---------------------------------------------------------------------------*\
    demDomainScene.C -- check the scene's domain against the mesh and complete it.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demDomain.H"
#include "DynamicList.H"
#include "FixedList.H"
#include "Vector2D.H"


// Does the list of axes contain this one?
bool Foam::demDomain::lists
(
    const dictionary& domain,
    const word& list,
    const direction k
) const
{
    const entry* e = domain.findEntry(list, keyType::LITERAL);

    if (!e || !e->isStream())
    {
        return false;                       // the core refuses a dictionary
    }
    for (const token& t : e->stream())
    {
        if (t.isWord() && t.wordToken() == vector::componentNames[k])
        {
            return true;
        }
    }
    return false;
}


// Limits of an axis in the scene must agree with the mesh
void Foam::demDomain::checkLimits
(
    const dictionary& domain,
    const direction k
) const
{
    scalar low = low_[k], high = high_[k];
    vector corner;

    if (domain.readIfPresent("min", corner))
    {
        low = corner[k];
    }
    if (domain.readIfPresent("max", corner))
    {
        high = corner[k];
    }
    if (domain.found(vector::componentNames[k]))
    {
        const List<scalar> both(domain.get<List<scalar>>(vector::componentNames[k]));
        low = both.size() > 0 ? both[0] : low;
        high = both.size() > 1 ? both[1] : high;
    }

    // Inclined patches: only the distance between them is compared
    const scalar difference =
        planar_[k]
      ? max(mag(low - low_[k]), mag(high - high_[k]))
      : mag(high - low - (high_[k] - low_[k]));

    if (difference > tolerance*(high_[k] - low_[k]))
    {
        FatalIOErrorInFunction(domain)
            << "domain ends at " << low << " and " << high << " m along "
            << vector::componentNames[k] << ", but the mesh, between its "
            << (kind_[k] == CYCLIC ? "cyclic" : "empty") << " patches ("
            << patch_[k] << "), at " << low_[k] << " and " << high_[k]
            << " m; take " << vector::componentNames[k] << " out of domain, the mesh determines it"
            << exit(FatalIOError);
    }
}


// Periodic axes in the scene must agree with the mesh
void Foam::demDomain::checkPeriodic(const dictionary& domain) const
{
    for (direction k = 0; k < 3; k++)
    {
        const bool periodic = lists(domain, "periodic", k);

        if (kind_[k] == CYCLIC && !periodic)
        {
            FatalIOErrorInFunction(domain)
                << "domain/periodic does not list " << vector::componentNames[k] << ", but patch "
                << patch_[k] << " is cyclic along it; take periodic out of"
                << " domain, the mesh determines it" << exit(FatalIOError);
        }
        if (kind_[k] != CYCLIC && periodic)
        {
            FatalIOErrorInFunction(domain)
                << "domain/periodic lists " << vector::componentNames[k] << ", but the mesh has"
                << " no cyclic patches along it; make its ends cyclic, or take "
                << vector::componentNames[k] << " out of periodic" << exit(FatalIOError);
        }
    }
}


// Set a list of axes; a FixedList is written without its size
void Foam::demDomain::setAxes
(
    dictionary& domain,
    const word& list,
    const UList<word>& axes
) const
{
    typedef FixedList<word, 1> one;
    typedef FixedList<word, 2> two;
    typedef FixedList<word, 3> three;

    switch (axes.size())
    {
        case 1: domain.set(list, one(axes)); break;
        case 2: domain.set(list, two(axes)); break;
        case 3: domain.set(list, three(axes)); break;
    }
}


void Foam::demDomain::complete(dictionary& scene, const bool walls) const
{
    if (scene.found("domain") && !scene.isDict("domain"))
    {
        return;                             // the core reports the error
    }

    dictionary domain(scene.subOrEmptyDict("domain"));
    const bool corners = domain.found("min") || domain.found("max");
    DynamicList<word> periodicAxes, flatAxes;

    if (domain.found("periodic"))
    {
        checkPeriodic(domain);
    }
    for (direction k = 0; k < 3; k++)
    {
        const bool isFlat = kind_[k] == EMPTY && !walls && !domain.found("flat");

        if (kind_[k] != CYCLIC && !isFlat)
        {
            continue;
        }
        checkLimits(domain, k);
        if (!corners && !domain.found(vector::componentNames[k]))
        {
            domain.set(vector::componentNames[k], Vector2D<scalar>(low_[k], high_[k]));
        }
        if (kind_[k] == CYCLIC)
        {
            periodicAxes.append(vector::componentNames[k]);
        }
        if (isFlat)
        {
            flatAxes.append(vector::componentNames[k]);
        }
    }

    if (!domain.found("periodic"))
    {
        setAxes(domain, "periodic", periodicAxes);
    }
    setAxes(domain, "flat", flatAxes);

    if (periodicAxes.size() || flatAxes.size())
    {
        scene.set("domain", domain);
    }
}
