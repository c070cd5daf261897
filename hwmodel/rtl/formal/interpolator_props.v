// What ties the parts of the interpolator together: for every command, drives' times that change at
// every clock, resets at any moment.
module interpolator_props #(
    parameter N = 24,
    parameter W = N < 32 ? N + 1 : 32
) (
    input wire           clk,
    input wire           rst,
    input wire           valid,
    input wire [2:0]     curve,
    input wire [2*W-1:0] start,
    input wire [2*W-1:0] endpoint,
    input wire           cw,
    input wire [1:0]     preset,
    input wire           normalize,
    input wire [23:0]    period,
    input wire           clear,
    input wire [15:0]    length,
    input wire [15:0]    space,
    input wire [15:0]    setup,
    input wire [15:0]    hold
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire        ready, done, running;
    wire [2:0]  error;
    wire [1:0]  step, dir, pulse, negative, pending;
    wire [23:0] period_q;

    interpolator #(.N(N), .AXES(2)) interpolator (
        .i_clk(clk), .i_rst(first | rst), .i_valid(valid), .o_ready(ready), .i_curve(curve),
        .i_start(start), .i_end(endpoint), .i_cw(cw), .i_preset(preset), .i_normalize(normalize),
        .i_period(period), .o_error(error), .i_clear(clear), .i_length(length), .i_space(space),
        .i_setup(setup), .i_hold(hold), .o_step(step), .o_dir(dir), .o_done(done),
        .o_running(running), .o_period(period_q), .o_pulse(pulse), .o_negative(negative),
        .o_pending(pending)
    );

    // The decoder refuses shorter ones, and the queue hands on what it took.
    always @* if (running) assume (period_q >= 6);

    always @* if (!first) begin
        // Every pulse finds its axis' slot free: none is lost.
        assert ((pulse & pending) == 0);
        // Done means that nothing is under way.
        if (done) assert (~running && pulse == 0 && pending == 0 && step == 0);
        // A refusal stops the handshake.
        if (error != 0) assert (~ready);
    end
endmodule
