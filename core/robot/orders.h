// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: The Pendesk authors
#pragma once

#include "journal/record.h"
#include "protocol/requests.h"
#include "robot/access.h"
#include "robot/arming.h"
#include "robot/conditions.h"
#include "robot/controller.h"
#include "session/session.h"
#include <QPointer>

namespace robot {

/// What is ordered, in the words that the journal keeps.
struct Order {
    Act act = Act::Hold;
    QString subject {}; ///< As on the pendant: "M005", "#27010", "WELD_A12".
    QString oldValue {}; ///< As last read; empty if it was not.
    QString newValue {};
};

/// How an order ended: done, or an Error of kind NotSent (a condition was not met), Refused or UnknownOutcome.
using OrderHandler = std::function<void(const values::Result<void> &)>;

/// One try to change something. Whoever carries it out tells its end; the journal hears of it exactly once. An attempt
/// that is deleted before its end was told ends with UnknownOutcome.
class Attempt : public QObject
{
    Q_OBJECT

public:
    ~Attempt() override;

    /// The first end counts. The attempt deletes itself.
    void end(const values::Result<void> &result);
    /// Ends as what it is by now: withheld, or sent and not answered.
    void abandon();

Q_SIGNALS:
    void ended(const journal::OrderRecord &record);

private:
    friend class Orders;
    Attempt(
        const Order &order, const journal::OrderRecord &blank, QObject *context, OrderHandler handler, QObject *parent);

    /// Whether this is under way and orders the same.
    [[nodiscard]] bool isSame(const Order &order) const;

    journal::OrderRecord m_record;
    Time m_begun = now();
    QPointer<QObject> m_context;
    OrderHandler m_handler;
    std::optional<values::Error> m_withheld; ///< Why it was never sent; it ends with the next turn of the event loop.
    bool m_isEnded = false;
};

/// A read under way: it is settled once.
class Question : public QObject
{
public:
    using QObject::QObject;
    bool settle()
    {
        deleteLater();
        return !std::exchange(m_isSettled, true);
    }

private:
    bool m_isSettled = false;
};

/// When a controller ceased to be armed, by this computer's clock, and why.
struct Disarmed {
    Arming::Drop reason;
    QDateTime at;
};

/// The one door through which everything goes that changes something at a controller. Each order is checked against
/// its conditions, sent once, and ends in a record, whether it was done, refused, withheld or never answered.
///
///     orders.send(SelectCycle {CycleMode::Step}, {Act::SelectCycle, {}, tr("continuous"), tr("step")}, this,
///         [this](const values::Result<void> &result) { … });
///
/// A handler runs exactly once, from the event loop and never from inside the call that gave it; not at all after its
/// context is gone, which does not call the order back. Everything under way ends as unknown when the link is lost or
/// closed; nothing is kept to be sent later.
class Orders : public QObject
{
    Q_OBJECT

public:
    /// All of them must outlive the orders.
    Orders(Controller &controller, Access &access, Arming &arming, QObject *parent = nullptr);
    /// What is still under way is recorded as unknown, and the controller is no longer armed.
    ~Orders() override;

    [[nodiscard]] Controller &controller() const { return m_controller; }
    [[nodiscard]] Access &access() const { return m_access; }
    [[nodiscard]] Arming &arming() const { return m_arming; }

    /// What the conditions are judged by now.
    [[nodiscard]] const Situation &situation() const { return m_situation; }
    [[nodiscard]] QList<Finding> findings(Act act) const { return robot::findings(act, m_situation); }
    [[nodiscard]] std::optional<Condition> obstacle(Act act) const { return robot::obstacle(act, m_situation); }
    /// Which instance a variable has was compared with the pendant (reference §10.1); true for a simulation.
    void setNumberingVerified(bool verified);

    /// Sends an order once, if every condition of its act is met.
    template <protocol::TypedRequest R>
    requires(R::effect != protocol::Effect::Reads && R::effect != protocol::Effect::Stops) void send(
        const R &request, const Order &order, QObject *context, OrderHandler handler)
    {
        Attempt *attempt = begin(order, context, std::move(handler));
        if (!attempt)
            return;
        const auto onReply = [attempt](const values::Result<void> &reply) { attempt->end(reply); };
        if constexpr (protocol::needsPermit(R::effect)) {
            const bool isSent = m_arming.withPermit(
                *this, [&](const session::Permit &permit) { session()->send(request, permit, attempt, onReply); });
            Q_ASSERT(isSent); // every act that starts or moves has the condition Armed
        } else {
            session()->send(request, attempt, onReply);
        }
    }

    /// Reads something that belongs to a procedure, such as the read back after a write. NotSent without a link,
    /// NoAnswer when the link is lost on the way.
    template <protocol::TypedRequest R, typename Handler>
    requires(R::effect == protocol::Effect::Reads) void read(
        const R &request, QObject *context, Handler handler, session::Priority priority = session::Priority::Page)
    {
        auto *question = new Question {this};
        const auto tell = [question, context = QPointer {context}, handler](
                              const values::Result<typename R::Reply> &reply) {
            if (question->settle() && context)
                handler(reply);
        };
        const auto fail = [tell](values::ErrorKind kind) { tell(values::failure(kind)); };
        if (!m_situation.isLinkUp) {
            const auto notSent = [fail]() { fail(values::ErrorKind::NotSent); };
            QMetaObject::invokeMethod(question, notSent, Qt::QueuedConnection);
            return;
        }
        connect(this, &Orders::linkDropped, question, [fail]() { fail(values::ErrorKind::NoAnswer); });
        session()->send(request, question, tell, priority);
    }

    /// Checks the conditions of something that goes another way, such as a file, and that the same is not under way:
    /// the same act, subject and new value. Returns nullptr if it is withheld, else whoever carries it out must call
    /// Attempt::end().
    [[nodiscard]] Attempt *begin(const Order &order, QObject *context, OrderHandler handler);

    /// HOLD on: always possible, see StopOrder. Every HOLD of the program comes through here. The packet leaves before
    /// window and journal hear of it.
    void hold() { hold({this}); }
    /// The same for several controllers: every packet leaves before anybody hears of one.
    static void hold(const QList<Orders *> &orders);
    /// Servo off: always possible, see StopOrder.
    void servoOff(QObject *context, OrderHandler handler);

    /// Arms this controller; returns false if a condition is not met.
    bool arm();
    [[nodiscard]] bool isArmed() const { return m_arming.isArmed(*this); }
    /// The last time; nullopt while it is armed and before the first time.
    [[nodiscard]] const std::optional<Disarmed> &lastDrop() const { return m_lastDrop; }
    /// HLOCK was switched on from here and not off again; the controller does not tell.
    [[nodiscard]] bool isPendantLocked() const { return m_isPendantLocked; }

Q_SIGNALS:
    /// An order came to its end.
    void recorded(const journal::OrderRecord &record);
    /// Something that conditions look at is another than before.
    void situationChanged();
    void pendantLockChanged();
    /// The link was lost or closed.
    void linkDropped();

private:
    [[nodiscard]] session::Session *session() const;
    [[nodiscard]] journal::OrderRecord blank() const;
    [[nodiscard]] Situation look() const;
    [[nodiscard]] values::Result<void> permission(const Order &order) const;
    Attempt *attempt(const Order &order, QObject *context, OrderHandler handler);
    void onLinkStateChanged();
    void onDropped(const QObject *robot, Arming::Drop reason);
    void update();
    void onHoldOrderChanged();
    void noteLock(const journal::OrderRecord &record);

    Controller &m_controller;
    Access &m_access;
    Arming &m_arming;
    bool m_isNumberingVerified;
    Situation m_situation;
    std::optional<Disarmed> m_lastDrop;
    bool m_isPendantLocked = false;
    QPointer<Attempt> m_hold;
};

} // namespace robot
