// What a parabola by point-by-point comparison always does: every parameter and end point, on the
// parabola or off it, every pattern of the pulse source.
module parabola_ppc_props #(
    parameter N = 24
) (
    input wire         clk,
    input wire         en,
    input wire         load,
    input wire [N-1:0] p,
    input wire [N-1:0] end_along,
    input wire [N-1:0] end_across,
    input wire         axis_is_y,
    input wire [1:0]   negative
);
    reg first = 1'b1;
    always @(posedge clk) first <= 1'b0;

    wire [1:0]   pulse, negative_q;
    wire         done, axis_is_y_q;
    wire [N+1:0] f_q;
    wire [N-1:0] v, p_q, je_along, je_across;

    parabola_ppc #(.N(N)) parabola (
        .i_clk(clk), .i_rst(first), .i_en(en), .i_load(load), .i_p(p), .i_end_along(end_along),
        .i_end_across(end_across), .i_axis_is_y(axis_is_y), .i_negative(negative), .o_pulse(pulse),
        .o_negative(negative_q), .o_done(done), .o_f(f_q), .o_v(v), .o_p(p_q),
        .o_je_along(je_along), .o_je_across(je_across), .o_axis_is_y(axis_is_y_q)
    );

    // The command that is carried out.
    reg [N-1:0] asked_along = 0, asked_across = 0, asked_p = 0;
    reg         asked_y = 0;
    always @(posedge clk)
        if (first) begin
            asked_along  <= 0;
            asked_across <= 0;
            asked_p      <= 0;
            asked_y      <= 0;
        end else if (load) begin
            asked_along  <= end_along;
            asked_across <= end_across;
            asked_p      <= p;
            asked_y      <= axis_is_y;
        end

    // The point, and its deviation v^2 - 2|p|u by the differences between neighbours.
    wire along  = asked_y ? pulse[1] : pulse[0];
    wire across = asked_y ? pulse[0] : pulse[1];
    reg         [N-1:0] gone_along = 0, gone_across = 0;
    reg  signed [N+3:0] deviation = 0;
    wire signed [N+3:0] twice_p = {3'b000, asked_p, 1'b0};
    wire signed [N+3:0] twice_v = {3'b000, gone_across, 1'b0};
    always @(posedge clk)
        if (first | load) begin
            gone_along  <= 0;
            gone_across <= 0;
            deviation   <= 0;
        end else begin
            gone_along  <= gone_along + {{(N-1){1'b0}}, along};
            gone_across <= gone_across + {{(N-1){1'b0}}, across};
            deviation   <= deviation - (along ? twice_p : 0) + (across ? twice_v + 1 : 0);
        end

    wire both = gone_along != asked_along & gone_across != asked_across;

    always @* if (!first) begin
        // No pulse after the end, nor without the pulse source; else one of one axis.
        assert (!((done | ~en) & pulse != 0));
        assert (done | ~en | (pulse == 2'b01) | (pulse == 2'b10));
        // Pulses and counters together are the end point: done means there, exactly, and no axis is
        // ever past it.
        assert (gone_along <= asked_along && gone_across <= asked_across);
        assert (gone_along + je_along == asked_along);
        assert (gone_across + je_across == asked_across);
        assert (done == (gone_along == asked_along && gone_across == asked_across));
        // The registers are what their names say.
        assert (v == gone_across && p_q == asked_p && axis_is_y_q == asked_y);
        assert (f_q == deviation[N+1:0]);
        // F's range, in which it does not wrap, as long as both axes are on their way.
        if (both) begin
            assert (deviation == $signed({{2{f_q[N+1]}}, f_q}));
            assert (deviation >= -twice_p);
            assert (deviation <= (gone_across == 0 ? 0 : twice_v - 2));
        end
        // Then the deviation decides, and afterwards the axis that does not stand is fed.
        if (~done & en) assert (along == (both ? deviation >= 0 : gone_across == asked_across));
    end
endmodule
