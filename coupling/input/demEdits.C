/*---------------------------------------------------------------------------*\
    demEdits.C -- edits of constant/demProperties during a run.

    SPDX-License-Identifier: GPL-3.0-or-later
\*---------------------------------------------------------------------------*/

#include "demEdits.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "OStringStream.H"

namespace Foam
{

static string textOf(const entry& e)
{
    OStringStream os;
    os << e;
    return os.str();
}


// Add the paths of entries that differ
static void compare
(
    const dictionary& before,
    const dictionary& now,
    const string& path,
    DynamicList<string>& differences
)
{
    forAllConstIters(before, iter)
    {
        const keyType& key = iter().keyword();

        if (!now.found(key, keyType::LITERAL))
        {
            differences.append("removed " + path + key);
        }
    }

    forAllConstIters(now, iter)
    {
        const keyType& key = iter().keyword();
        const entry* old = before.findEntry(key, keyType::LITERAL);

        if (!old)
        {
            differences.append("added " + path + key);
        }
        else if (old->isDict() && iter().isDict())
        {
            compare(old->dict(), iter().dict(), path + key + "/", differences);
        }
        else if (textOf(*old) != textOf(iter()))
        {
            differences.append("changed " + path + key);
        }
    }
}

} // End namespace Foam


Foam::demEdits::demEdits(const Time& time, const fileName& file)
:
    time_(time),
    file_(file),
    changed_(0)
{
    string why;

    if (Pstream::master() && time_.runTimeModifiable())
    {
        changed_ = highResLastModified(file_);
        read(used_, why);
    }
}


// A file that is half written, or has a mistake, must not end the run
bool Foam::demEdits::read(dictionary& content, string& why) const
{
    const bool throwing = FatalIOError.throwExceptions();
    const bool throwingError = FatalError.throwExceptions();
    bool done = false;

    try
    {
        IFstream file(file_);
        done = isFile(file_) && content.read(file);
        why = "it cannot be read";
    }
    catch (const error& e)
    {
        why = e.message();
    }
    FatalIOError.throwExceptions(throwing);
    FatalError.throwExceptions(throwingError);
    return done;
}


void Foam::demEdits::report()
{
    if (!Pstream::master() || !time_.runTimeModifiable())
    {
        return;
    }

    const double changed = highResLastModified(file_);
    if (changed == changed_ || changed == 0)
    {
        return;
    }
    changed_ = changed;

    dictionary now;
    DynamicList<string> differences;
    string why;

    if (!read(now, why))
    {
        Info<< "Suna: " << file_.name() << " has changed during the run and cannot be read: "
            << why.c_str() << "; the run goes on with what it has read at its start" << endl;
        return;
    }

    compare(used_, now, "", differences);
    if (differences.empty())
    {
        Info<< "Suna: " << file_.name() << " is again what the run has read" << endl;
        return;
    }

    Info<< "Suna: " << file_.name() << " has changed during the run: ";
    forAll(differences, k)
    {
        Info<< (k ? ", " : "") << differences[k].c_str();
    }
    Info<< "; the run goes on without that, and takes it when it is started again"
        << " (startFrom latestTime continues)" << endl;
}
