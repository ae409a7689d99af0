/* A study of the flight at hand: a worker thread computes, its dialog waits. */
#pragma once
#include "app.h"

/* A computation: what it needs and what it finds, shared by its thread and the dialog. */
struct Study {
    Scene scene;
    std::wstring folder;
    double from_s, to_s;
    size_t most;
    sins_requirement requirement = sized<sins_requirement>();
    sins_budget_request request = sized<sins_budget_request>();
    sins_options options = sized<sins_options>();
    sins_cost cost = sized<sins_cost>();
    std::vector<sins_budget_row> rows;
    sins_budget budget = sized<sins_budget>();
    sins_status (*call)(Study &, const sins_sim *, const std::vector<sins_flight_sample> &);
    sins_status status = SINS_OK;
    std::wstring sentence; /* why it failed */
    std::atomic<bool> is_cancelled{false}, is_done{false};

    void compute();
};

class StudyDialog : public Dialog {
public:
    StudyDialog(App &app, size_t most) : app_(app), most_(most) {}
    ~StudyDialog() override { cancel(); }

protected:
    void on_init() override;
    void on_command(int id, int code) override;
    void on_timer() override;
    virtual void begin(Study &study) = 0;
    virtual void show_result(const Study &study) = 0;
    virtual void adopt() {}
    /* A number of a field, 0 where it is empty. What is none is marked. */
    double number(int id);

    App &app_;

private:
    void start();
    void cancel();
    size_t most_;                  /* samples */
    std::shared_ptr<Study> study_; /* the one that is waited for */
};
