/*---------------------------------------------------------------------------*\
    demRun.C -- options, lock, written times and end of a run.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demRun.H"
#include "demSettle.H"

void Foam::demRun::addOptions()
{
    argList::addBoolOption
    (
        "plan",
        "Print the plan of the run (effects, time steps, cost), then stop"
    );
    argList::addBoolOption
    (
        "settle",
        "Settle the particles of insert in the walls of the mesh, without the"
        " fluid, until they rest; write the snapshot for start, then stop"
    );
}


Foam::demRun::demRun(const argList& args, Time& time)
:
    time_(time),
    planOnly_(args.found("plan")),
    settleOnly_(args.found("settle")),
    planned_(false)
{
    if (planOnly_)
    {
        time_.functionObjects().off();
    }
}


bool Foam::demRun::settle(const fvMesh& mesh) const
{
    if (settleOnly_)
    {
        demSettle(mesh).run();
        Info<< "End\n" << endl;
    }
    return settleOnly_;
}


void Foam::demRun::begin()
{
    Info<< "\nStarting time loop\n" << endl;
    if (!planOnly_)
    {
        if (demStop::atEnd(time_))
        {
            Info<< "Suna: WARNING: no step is made: the run begins at " << time_.timeName()
                << " s and ends at " << time_.endTime().value() << " s; raise endTime, or begin"
                << " earlier (startFrom in system/controlDict)" << nl << endl;
        }
        stop_.reset(new demStop(time_));
    }
}


bool Foam::demRun::plan(demCloud& cloud, const demFlow& flow, const demPlan::step& ahead)
{
    if (!planned_)
    {
        cloud.plan(flow, ahead);
        planned_ = true;
    }
    return planOnly_;
}


void Foam::demRun::endStep(demCloud& cloud)
{
    if (!stop_().atStepEnd(time_))
    {
        time_.write();
    }
    if (time_.writeTime())
    {
        cloud.write();
    }
    time_.printExecutionTime(Info);
}


void Foam::demRun::end() const
{
    if (planOnly_ && !planned_)
    {
        FatalErrorInFunction
            << "There is nothing to plan: the run begins at "
            << time_.timeName() << " s and ends at "
            << time_.endTime().value() << " s; raise endTime, or begin"
            << " earlier (startFrom in system/controlDict)"
            << exit(FatalError);
    }
    Info<< "End\n" << endl;
}
